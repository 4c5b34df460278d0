#!/usr/bin/env python3
"""Two threads beside one: rounds of both in turn, medians of the wall time of stepping.

    tests/benchmarks/threads.py [DRIVER] [ROUNDS]
"""
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
VISCOUS = "/viscosity=" + json.dumps({"type": "monaghan", "alpha": 0.06, "beta": 0})
LATTICE = ["/particles/motion=frozen", "/equations=linear_acoustics", "/integrator/type=leapfrog"]
CASES = {    # particles to a side, steps, settings
    "lattice 2-D, 256^2, in cache": (256, 1500, LATTICE),
    "lattice 2-D, 1024^2, in memory": (1024, 60, LATTICE),
    "frozen 2-D, jittered 256^2": (256, 150, LATTICE + ["/particles/jitter=0.2"]),
    "moving 2-D, 256^2, densities and viscosity": (256, 60, [VISCOUS]),
}


def wall(driver, threads, n, steps, settings):
    sets = [word for s in [f"/particles/dx={1 / n!r}", f"/until={0.2999 * steps / n!r}", *settings] for word in ("--set", s)]
    with tempfile.TemporaryDirectory() as folder:
        out = subprocess.run([driver, "run", str(HERE / "peers/standing_wave.json"), "--threads", str(threads), "--json", "--out", folder + "/out", *sets],
                             check=True, capture_output=True, text=True)
    return json.loads(out.stdout)["wall_s"]


def main():
    driver = sys.argv[1] if len(sys.argv) > 1 else str(HERE.parents[1] / "build/release/bin/sphonic")
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    print("| set | one thread, s | two, s | faster by (target 1.8) |\n|---|---|---|---|")
    for name, case in CASES.items():
        pairs = [(wall(driver, 1, *case), wall(driver, 2, *case)) for _ in range(rounds)]
        one, two = (statistics.median(column) for column in zip(*pairs))
        print(f"| {name} | {one:.3f} | {two:.3f} | {statistics.median(a / b for a, b in pairs):.2f} |", flush=True)


if __name__ == "__main__":
    main()
