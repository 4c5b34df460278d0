#!/usr/bin/python3
"""sphonic beside PySPH (Debian's python3-pysph) on one thread: rounds of both in turn, medians of CPU time, ratios.

    tests/benchmarks/peers/compare.py [DRIVER] [ROUNDS]

The same standing wave (pysph_wave.py, standing_wave.json): periodic box, cubic spline, h = 1.3 dx, Monaghan's viscosity. PySPH:
weakly compressible scheme, predictor and corrector with one evaluation per step, which for linear rates is leapfrog_li2015. sphonic:
moving particles with the nonlinear equations and this integrator, and the linear ones by leapfrog on a frozen lattice without viscosity.
"""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SCENES = {    # particles to a side, steps of PySPH, moving and frozen
    2: (256, 10, 60, 2000),
    3: (40, 5, 30, 600),
}
TARGETS = {2: (9, 230), 3: (14, 230)}
VISCOUS = ["/viscosity=" + json.dumps({"type": "monaghan", "alpha": 0.06, "beta": 0})]
FROZEN = ["/particles/motion=frozen", "/equations=linear_acoustics", "/integrator/type=leapfrog"]


def peer(dimension, n, steps):
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    out = subprocess.run([str(HERE / "pysph_wave.py"), str(dimension), str(n), str(steps)], env=environment, check=True, capture_output=True, text=True)
    return float(out.stdout.split()[-1])


def ours(driver, dimension, n, steps, settings=()):
    axes = range(dimension)
    assignments = [f"/dimension={dimension}", f"/particles/dx={1 / n!r}", f"/until={0.2999 * steps / n!r}",
                   "/particles/lower=" + json.dumps([0 for _ in axes]), "/particles/upper=" + json.dumps([1 for _ in axes]),
                   "/initial/u=" + json.dumps(["1e-3*sin(2*pi*x)"] + ["0"] * (dimension - 1)), *settings]
    sets = [word for assignment in assignments for word in ("--set", assignment)]
    with tempfile.TemporaryDirectory() as folder:
        out = subprocess.run([driver, "run", str(HERE / "standing_wave.json"), "--threads", "1", "--json", "--out", folder + "/out", *sets],
                             check=True, capture_output=True, text=True)
    return json.loads(out.stdout)["ns_per_particle_step"]


def main():
    driver = sys.argv[1] if len(sys.argv) > 1 else str(HERE.parents[2] / "build/release/bin/sphonic")
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    print("| box | PySPH, ns | moving, ns | frozen lattice, ns | moving faster by (target) | lattice faster by (target) |\n|---|---|---|---|---|---|")
    for dimension, (n, *steps) in SCENES.items():
        times = [(peer(dimension, n, steps[0]), ours(driver, dimension, n, steps[1], VISCOUS), ours(driver, dimension, n, steps[2], FROZEN))
                 for _ in range(rounds)]
        p, m, f = (statistics.median(column) for column in zip(*times))
        ratios = [statistics.median(row[0] / row[k] for row in times) for k in (1, 2)]
        print(f"| {dimension}-D, {n**dimension} particles | {p:.0f} | {m:.1f} | {f:.2f} | {ratios[0]:.1f} ({TARGETS[dimension][0]}) | {ratios[1]:.0f} ({TARGETS[dimension][1]}) |", flush=True)


if __name__ == "__main__":
    main()
