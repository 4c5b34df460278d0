#!/usr/bin/python3
"""A standing wave in a periodic box, weakly compressible with Monaghan's viscosity (cubic spline, h = 1.3 dx), as PySPH
computes it on one thread. Prints nanoseconds of CPU time per particle-step, without set-up and compilation.

    pysph_wave.py DIMENSION N STEPS      N particles to a side
"""
import sys
import tempfile
import time

import numpy as np
from pysph.base.kernels import CubicSpline
from pysph.base.nnps import DomainManager
from pysph.base.utils import get_particle_array
from pysph.solver.application import Application
from pysph.sph.scheme import WCSPHScheme

WARM_UP = 3    # steps


class StandingWave(Application):
    def __init__(self, dimension, n, steps, folder):
        self.d, self.n, self.steps = dimension, n, steps
        self.dx = 1.0 / n
        self.begin = self.cpu_s = None
        super().__init__(fname="standing_wave", output_dir=folder)

    def create_domain(self):
        sides = {f"{a}{end}": value for a in "xyz"[:self.d] for end, value in (("min", 0.0), ("max", 1.0))}
        return DomainManager(**sides, **{f"periodic_in_{a}": True for a in "xyz"[:self.d]})

    def create_particles(self):
        line = (np.arange(self.n) + 0.5) * self.dx
        x = [a.ravel() for a in np.meshgrid(*[line] * self.d, indexing="ij")]
        places = dict(zip("xyz", x))
        fluid = get_particle_array(name="fluid", m=self.dx**self.d, rho=1.0, h=1.3 * self.dx, u=1e-3 * np.sin(2 * np.pi * x[0]), **places)
        self.scheme.setup_properties([fluid])
        return [fluid]

    def create_scheme(self):
        scheme = WCSPHScheme(["fluid"], [], dim=self.d, rho0=1.0, c0=1.0, h0=1.3 * self.dx, hdx=1.3, gamma=7.0, alpha=0.06, beta=0.0)
        dt = 0.3 * self.dx
        scheme.configure_solver(kernel=CubicSpline(dim=self.d), dt=dt, tf=(self.steps + WARM_UP - 0.5) * dt, adaptive_timestep=False)
        return scheme

    def post_step(self, solver):
        if solver.count + 1 == WARM_UP:
            self.begin = time.process_time()
        self.cpu_s, self.last = time.process_time(), solver.count + 1


def main():
    dimension, n, steps = map(int, sys.argv[1:4])
    with tempfile.TemporaryDirectory() as folder:
        wave = StandingWave(dimension, n, steps, folder)
        wave.run(["--disable-output", "--no-openmp"])
        print(1e9 * (wave.cpu_s - wave.begin) / ((wave.last - WARM_UP) * n**dimension))


if __name__ == "__main__":
    main()
