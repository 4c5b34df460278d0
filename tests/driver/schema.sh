#!/usr/bin/env bash
# `sphonic schema` against the reader itself: what `check` takes conforms, and what it refuses does not.
#
#   schema.sh DRIVER REPOSITORY
# shellcheck disable=SC2015  # ok and failed always succeed
set -euo pipefail

driver=$(readlink -f -- "$1")
repository=$(readlink -f -- "$2")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
# shellcheck source=tests/driver/report.sh
source "$repository/tests/driver/report.sh"
cd -- "$scratch"
unset SPHONIC_PLUGIN_PATH

code=0
"$driver" schema >schema.json 2>err || code=$?
[[ $code == 0 && ! -s err ]] && ok "schema ends with exit code 0 and no word on stderr" || failed "schema" "exit code: $code" "$(<err)"

mkdir broken && echo 'not a library' >broken/kernel.fake.so
code=0
"$driver" schema --plugin-path broken >broken.json 2>err || code=$?
[[ $code == 4 && $(<err) == *kernel.fake.so* ]] && ok "a broken plugin is named, with exit code 4" || failed "a broken plugin" "exit code: $code" "$(<err)"
cmp -s schema.json broken.json && ok "and the schema is that of the others" || failed "the schema beside a broken plugin"

"$driver" run "$repository/cases/li2015/propagation.json" --set /until=0.001 --out result >/dev/null

if ! command -v python3 >/dev/null; then
    echo "skipped what needs python3: there is none"
else
    python3 - "$driver" "$repository" <<'PYTHON' || failures=$((failures + 1))
import copy, glob, json, subprocess, sys

driver, repository = sys.argv[1:]
with open("schema.json") as file:
    schema = json.load(file)
failures = 0


def check(what, passed, why=""):
    global failures
    failures += not passed
    print("ok     " if passed else "FAILED ", what, "" if passed else why)


plugins = json.loads(subprocess.run([driver, "list", "--json"], capture_output=True, check=True).stdout)
text = json.dumps(schema)
for plugin in plugins:
    named = '{"const": "%s", "description": %s}' % (plugin["name"], json.dumps(plugin["doc"]))
    rows = [row for row in plugin["parameters"] if '"%s": {"type": ' % row["name"] not in text]
    check(f"{plugin['kind']} {plugin['name']} is in the schema", named in text and not rows, rows)

try:
    import jsonschema
except ImportError:
    print("skipped validation: python3 has no jsonschema")
    sys.exit(failures > 0)
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)


def complaint(case):
    error = jsonschema.exceptions.best_match(validator.iter_errors(case))
    return f"{error.json_path}: {error.message}" if error else ""


for path in sorted(glob.glob(repository + "/cases/*/*.json")) + ["result/resolved.json"]:
    with open(path) as file:
        case = json.load(file)
    if "/equations/" in path:
        case = {"dimension": 1, "medium": {"c0": 1, "rho0": 1}, "kernel": {"type": "cubic_spline", "h": 1}, "equations": case,
                "particles": {"type": "lattice", "dx": 1, "lower": [0], "upper": [9]}, "until": 1,
                "integrator": {"type": "rk4"}}
    check(f"{path.removeprefix(repository + '/')} conforms", not complaint(case), complaint(case))

BASE = {
    "dimension": 1,
    "medium": {"c0": 340, "rho0": 1.0},
    "particles": {"type": "lattice", "dx": 0.04, "lower": [-1], "upper": [4]},
    "kernel": {"type": "cubic_spline", "h": 0.04},
    "equations": {"p": [{"divergence": "u", "form": "difference", "times": "-rho0*c0^2"}],
                  "u": [{"gradient": "p", "form": {"type": "sum"}, "times": "-1/rho0"}]},
    "viscosity": {"type": "monaghan"},
    "sources": [{"type": "plane_wave", "region": "x < 0", "omega": 500, "direction": [1]}],
    "initial": {"p": "0", "u": ["0"]},
    "boundaries": [{"type": "free", "face": "x_max"}],
    "integrator": {"type": "symplectic_euler", "courant": 0.1},
    "until": 0.005,
    "reference": {"type": "plane_wave_front", "region": "0 <= x <= 4"},
    "output": {"every": 0.001, "probes": [[2.0]]},
}
ABSENT = object()
TERM = {"divergence": "u", "form": "difference", "times": "-rho0*c0^2"}
BRAKED = [{"gradient": "p", "form": "sum", "times": "-1/rho0"}, {"viscosity": "monaghan", "alpha": 0.1}]
POINT = {"type": "point", "omega": 100, "position": [1]}
EDGE = {"type": "expression", "surface": "3 - x"}
WAVE = {"type": "travelling_wave", "wave_number": [1]}
DENSITY = {"drho": [TERM | {"times": "-rho0"}], "p": {"state": "acoustic", "of": "drho"}, "u": BRAKED[:1]}

PLANNED = [("method",), ("equations",), ("kernel",), ("integrator",), ("integrator", "type"), ("integrator", "courant"), ("particles", "dx")]
OPEN = [(("viscosity",), ABSENT), (("until",), 0.003), (("kernel",), {"type": "cubic_spline", "h_over_dx": 1.3})]
LAYER = [{"type": "absorbing_layer", "face": "x_max", "thickness": 1, "attenuation": "auto"}]
GRID = [(("method",), {"type": "fdtd"}), (("equations",), ABSENT), (("viscosity",), ABSENT), (("kernel",), ABSENT)]


def media(first={}, **second):
    air = {"c0": 340, "rho0": 1.2}
    return GRID + [(("medium",), [air | first, air | {"region": "x > 3"} | second])]


def edited(*edits):
    """BASE with each (path, value) put in place; a part of a path that is not there is made."""
    case = copy.deepcopy(BASE)
    for path, value in edits:
        at = case
        *parents, last = path
        for part in parents:
            at = at.setdefault(part, {}) if isinstance(at, dict) else at[part]
        if value is ABSENT:
            del at[last]
        else:
            at[last] = value
    return case


# One change of BASE a row. The reader says which are right: this table does not.
changes = [
    [],
    # names
    [(("$schema",), "schema.json")], [(("$schema",), 3)], [(("schema",), "schema.json")], [(("equations", "c0"), [TERM])],
    [(("equations", "a b"), [TERM])], [(("equations", ""), [TERM])], [(("equations", "x"), [TERM])], [(("equations", "q"), [TERM])],
    [(("kernels",), {"": {"type": "gaussian", "h": 0.08}})], [(("kernel", "typ"), "gaussian")], [(("methd",), {"type": "fdtd"})], [(("kernel", "type"), "cubic_splin")],
    [(("particles", "motion"), "frozn")], [(("particles", "motion"), "lagrangian")], [(("reference", "regoin"), "x > 0")],
    [(("kernel", "type"), ABSENT)], [(("kernel", "cutoff"), 3)], [(("kernel",), {"type": "gaussian", "h": 0.04, "cutoff": 2})],
    # values
    [(("kernel", "h"), -1)], [(("kernel", "h"), 0)], [(("kernel", "h"), "0.04")], [(("kernel", "h_over_dx"), 1)],
    [(("kernel", "h"), ABSENT)], [(("kernel",), {"type": "cubic_spline", "h_over_dx": 1.3})], [(("kernel",), "cubic_spline")],
    [(("kernel",), ABSENT)], [(("kernel",), ABSENT), (("kernels",), {})],
    [(("kernel",), ABSENT), (("kernels",), {"wide": {"type": "gaussian", "h": 0.08}})],
    [(("kernels",), {"wide": {"type": "gaussian"}})],
    [(("kernel",), {"type": "gaussian", "h": 0.04, "cutoff": 0.5})], [(("kernel",), {"type": "gaussian", "h": 0.04, "cutoff": 11})],
    [(("kernel",), {"type": "gaussian", "h": 0.04, "renormalise": 1})],
    [(("kernel",), {"type": "gaussian", "h": 0.04, "renormalise": True})],
    [(("title",), 3)], [(("title",), "a wave")], [(("medium", "rho0"), ABSENT)], [(("medium", "c0"), "fast")], [(("medium", "c0"), 0)],
    [(("medium", "T"), 293)], [(("dimension",), 4)], [(("dimension",), 1.0)], [(("dimension",), 1.5)],
    [(("title",), "")], [(("particles", "seed"), 3.0)], [(("particles", "seed"), -1)], [(("particles", "seed"), 1.5)], [(("dimension",), "1")], [(("dimension",), ABSENT)], [(("until",), 0)],
    [(("until",), ABSENT)], [(("viscosity", "alpha"), 10)], [(("viscosity", "alpha"), 10.5)], [(("viscosity", "alpha"), None)],
    # space
    [(("particles", "dx"), ABSENT)], [(("particles", "lower"), ABSENT)], [(("particles", "upper"), [4, 4])], [(("particles", "lower"), [])],
    [(("particles", "velocity"), "u")], [(("particles",), ABSENT)], [(("boundaries", 0, "face"), "y_max")],
    [(("boundaries", 0, "face"), "all")], [(("boundaries", 0, "face"), ABSENT)], [(("boundaries",), {})], [(("boundaries",), ABSENT)],
    # obstacles
    [(("obstacles",), [])], [(("obstacles",), {})], [(("obstacles",), [EDGE])], [(("obstacles",), [EDGE | {"type": "edge"}])],
    [(("obstacles",), [EDGE | {"wall": "soft", "keep": "outside"}])], [(("obstacles",), [EDGE | {"wall": "hard"}])],
    [(("obstacles",), [EDGE | {"keep": 1}])], [(("obstacles",), [EDGE | {"radius": 1}])], [(("obstacles",), [{"type": "circle"}])],
    [(("obstacles",), [EDGE]), (("method",), {"type": "kspace"})], [(("obstacles",), []), (("method",), {"type": "fdtd"})],
    [(("obstacles",), [EDGE]), (("method",), {"type": "fdtd"})],
    # time
    [(("integrator", "dt"), 1e-6)], [(("integrator", "safety"), 0.5)], [(("integrator",), {"type": "rk4", "safety": 0.5, "dt": 1e-6})], [(("integrator", "courant"), ABSENT)],
    [(("integrator",), {"type": "rk4", "safety": 0.5})], [(("integrator",), {"type": "rk4", "safety": 2.5})],
    [(("integrator",), {"type": "rk4", "dt": 1e-6})], [(("integrator", "courant_length"), "h")],
    [(("integrator", "courant_length"), "L")], [(("integrator", "unstable"), "allow")], [(("integrator",), ABSENT)],
    # sound
    [(("sources",), [POINT | {"region": "x > -1"}]), (("reference",), ABSENT)], [(("sources",), [POINT | {"signal": "sin"}])],
    [(("sources",), [POINT]), (("reference",), ABSENT)], [(("sources",), [POINT | {"position": [1, 1]}]), (("reference",), ABSENT)],
    [(("sources",), [{"type": "exact", "region": "x < 0"}]), (("reference",), WAVE)], [(("sources",), [{"type": "exact"}]), (("reference",), WAVE)],
    [(("reference",), WAVE | {"wave_number": [1, 1]})], [(("sources", 0, "direction"), [1, 0])], [(("sources", 0, "phase_origin"), [0])],
    [(("sources",), {})], [(("sources", 0, "region"), ABSENT)], [(("sources", 0, "omega"), ABSENT)], [(("sources", 0, "omega"), 0)],
    [(("sources", 0, "direction"), 1)], [(("sources", 0, "direction"), [1, 0, 0, 0])], [(("initial", "p"), 0)],
    [(("initial", "u"), "0")], [(("initial", "u"), ["0", "0"])], [(("initial",), ABSENT)], [(("reference", "scale"), 0)],
    [(("reference", "scale"), 20)], [(("reference",), ABSENT)], [(("reference", "region"), 3)],
    [(("output", "every"), -1)], [(("output", "probes"), [2.0])], [(("output", "probes"), [[2.0, 0]])], [(("output",), ABSENT)],
    [(("output", "probs"), [])], [(("provenance",), {"any": "thing"})], [(("provenance",), 3)],
    # equations
    [(("equations",), "linear_acoustics")], [(("equations",), 3)], [(("equations",), {})], [(("equations",), ABSENT)],
    [(("equations",), ABSENT), (("viscosity",), ABSENT)], [(("equations", "p"), [])], [(("equations", "u"), ABSENT)],
    [(("equations",), DENSITY)], [(("equations",), DENSITY | {"p": {"state": "acustic", "of": "drho"}})],
    [(("equations",), DENSITY | {"p": {"state": "acoustic"}})], [(("equations",), DENSITY | {"p": {"of": "drho"}})],
    [(("equations",), DENSITY | {"order": [["u"], ["drho", "x"]]})], [(("equations",), DENSITY | {"order": [[], ["u"], ["drho"]]})], [(("equations", "order"), "u")],
    [(("equations", "p", 0, "form"), "diference")], [(("equations", "p", 0, "form"), ABSENT)],
    [(("equations", "p", 0, "form"), {"type": "sum", "beta": 1})], [(("equations", "p", 0, "times"), 3)],
    [(("equations", "p", 0, "gradient"), "p")], [(("equations", "p", 0, "divergence"), ABSENT)],
    [(("equations", "p", 0), {"gradient": "p", "form": "sum"})], [(("equations", "u", 0), TERM)],
    [(("equations", "u"), BRAKED), (("viscosity",), ABSENT)],
    [(("equations", "u"), BRAKED[:1] + [{"viscosity": "monaghan", "alfa": 1}]), (("viscosity",), ABSENT)],
    [(("equations", "u"), BRAKED[:1] + [{"viscosity": "monaghan", "beta": 11}]), (("viscosity",), ABSENT)],
    # methods
    [(("method",), {"type": "particles"})], [(("method",), {})], [(("method",), {"type": "fdtd"})],
    [(("method",), {"type": "fdtd"}), (("equations",), ABSENT)],
    [(("method",), {"type": "fdtd"}), (("equations",), ABSENT), (("viscosity",), ABSENT), (("kernel",), ABSENT)],
    # media
    media(), media(dx=0.02), media(dx=-1), media(dx="auto"), media(dx="atuo"), media({"dx": 0.02}), media(dx="auto") + [(("accuracy",), {"target": 0.2}), (("until",), 0.003)],
    # what plan decides
    [(("accuracy",), {"target": 2})], [(("accuracy",), {"goal": 0.1})],
    *[[(path, "auto")] for path in PLANNED],
    *[OPEN + [(path, "auto"), (("accuracy",), {"target": 0.2})] for path in PLANNED + [("active",), ("particles", "motion")]],
    [(("integrator",), ABSENT), (("particles", "dx"), ABSENT), (("accuracy",), {"target": 0.2})] + OPEN, [(("kernel",), "atuo"), (("accuracy",), {"target": 0.2})],
    [(("particles", "dx"), "atuo"), (("accuracy",), {"target": 0.2})], [(("integrator", "type"), "atuo"), (("accuracy",), {"target": 0.2})],
    [(("kernel", "type"), "auto")], [(("until",), "auto")], [(("boundaries",), LAYER)], [(("boundaries",), LAYER), (("accuracy",), {"target": 0.2})] + OPEN,
]
taken = 0
for edits in changes:
    case = edited(*edits)
    with open("case.json", "w") as file:
        json.dump(case, file)
    reader = subprocess.run([driver, "check", "case.json"], capture_output=True, text=True)
    said = complaint(case)
    shown = ", ".join(f"/{'/'.join(map(str, path))} = {'(none)' if value is ABSENT else json.dumps(value)}" for path, value in edits)
    taken += reader.returncode == 0
    check(f"check and the schema agree on {shown or 'the case'}", (reader.returncode == 0) == (not said),
          f"\n        check:  {reader.stderr.strip()[-200:] or 'takes it'}\n        schema: {said[:200] or 'takes it'}")
check("both takes and refuses some", 0 < taken < len(changes))
check("a key with a typo is named", "'typ' was unexpected" in complaint(edited((("kernel", "typ"), "gaussian"))))
check("a value out of range is named", complaint(edited((("kernel", "h"), -1))).startswith("$.kernel.h: -1 "))
sys.exit(failures > 0)
PYTHON
fi

((failures == 0)) || { echo "$failures checks failed"; exit 1; }
echo "all checks passed"
