"""A standing wave in a periodic box, peers/standing_wave.json, run by the driver in so many dimensions, particles and steps."""
import json
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
DRIVER = str(HERE.parents[1] / "build/release/bin/sphonic")
VISCOUS = ["/viscosity=" + json.dumps({"type": "monaghan", "alpha": 0.06, "beta": 0})]
LATTICE = ["/particles/motion=frozen", "/equations=linear_acoustics", "/integrator/type=leapfrog"]


def summary(driver, dimension, n, steps, settings=(), threads=1):
    """Of a run with n particles to a side."""
    axes = range(dimension)
    assignments = [f"/dimension={dimension}", f"/particles/dx={1 / n!r}", f"/until={0.2999 * steps / n!r}",
                   "/particles/lower=" + json.dumps([0 for _ in axes]), "/particles/upper=" + json.dumps([1 for _ in axes]),
                   "/initial/u=" + json.dumps(["1e-3*sin(2*pi*x)"] + ["0"] * (dimension - 1)), *settings]
    sets = [word for assignment in assignments for word in ("--set", assignment)]
    with tempfile.TemporaryDirectory() as folder:
        out = subprocess.run([driver, "run", str(HERE / "peers/standing_wave.json"), "--threads", str(threads), "--json", "--out", folder + "/out", *sets],
                             check=True, capture_output=True, text=True)
    return json.loads(out.stdout)
