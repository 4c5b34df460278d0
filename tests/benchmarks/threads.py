#!/usr/bin/env python3
"""Two threads beside one: rounds of both in turn, medians of the wall time of stepping.

    tests/benchmarks/threads.py [DRIVER] [ROUNDS]
"""
import statistics
import sys

from standing_wave import DRIVER, LATTICE, VISCOUS, summary

CASES = {    # particles to a side, steps, settings
    "lattice 2-D, 256^2, in cache": (256, 1500, LATTICE),
    "lattice 2-D, 1024^2, in memory": (1024, 60, LATTICE),
    "frozen 2-D, jittered 256^2": (256, 150, LATTICE + ["/particles/jitter=0.2"]),
    "moving 2-D, 256^2, densities and viscosity": (256, 60, VISCOUS),
}


def main():
    driver = sys.argv[1] if len(sys.argv) > 1 else DRIVER
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    print("| set | one thread, s | two, s | faster by (target 1.8) |\n|---|---|---|---|")
    for name, case in CASES.items():
        pairs = [tuple(summary(driver, 2, *case, threads)["wall_s"] for threads in (1, 2)) for _ in range(rounds)]
        one, two = (statistics.median(column) for column in zip(*pairs))
        print(f"| {name} | {one:.3f} | {two:.3f} | {statistics.median(a / b for a, b in pairs):.2f} |", flush=True)


if __name__ == "__main__":
    main()
