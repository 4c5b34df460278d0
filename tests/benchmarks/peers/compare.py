#!/usr/bin/python3
"""sphonic beside PySPH (Debian's python3-pysph) on one thread: rounds of both in turn, medians of CPU time, ratios.

    tests/benchmarks/peers/compare.py [DRIVER] [ROUNDS]

The same standing wave (pysph_wave.py, standing_wave.json): periodic box, cubic spline, h = 1.3 dx, Monaghan's viscosity. PySPH:
weakly compressible scheme, predictor and corrector with one evaluation per step, which for linear rates is leapfrog_li2015. sphonic:
moving particles with the nonlinear equations and this integrator, and the linear ones by leapfrog on a frozen lattice without viscosity.
"""
import os
import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from standing_wave import DRIVER, LATTICE, VISCOUS, summary  # noqa: E402

SCENES = {    # particles to a side, steps of PySPH, moving and frozen
    2: (256, 10, 60, 2000),
    3: (40, 5, 30, 600),
}
TARGETS = {2: (9, 230), 3: (14, 230)}


def peer(dimension, n, steps):
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    out = subprocess.run([str(HERE / "pysph_wave.py"), str(dimension), str(n), str(steps)], env=environment, check=True, capture_output=True, text=True)
    return float(out.stdout.split()[-1])


def ns(run):
    return run["ns_per_particle_step"]


def main():
    driver = sys.argv[1] if len(sys.argv) > 1 else DRIVER
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    print("| box | PySPH, ns | moving, ns | frozen lattice, ns | moving faster by (target) | lattice faster by (target) |\n|---|---|---|---|---|---|")
    for dimension, (n, *steps) in SCENES.items():
        times = [(peer(dimension, n, steps[0]), ns(summary(driver, dimension, n, steps[1], VISCOUS)), ns(summary(driver, dimension, n, steps[2], LATTICE)))
                 for _ in range(rounds)]
        p, m, f = (statistics.median(column) for column in zip(*times))
        ratios = [statistics.median(row[0] / row[k] for row in times) for k in (1, 2)]
        print(f"| {dimension}-D, {n**dimension} particles | {p:.0f} | {m:.1f} | {f:.2f} | {ratios[0]:.1f} ({TARGETS[dimension][0]}) | {ratios[1]:.0f} ({TARGETS[dimension][1]}) |", flush=True)


if __name__ == "__main__":
    main()
