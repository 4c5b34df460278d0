#!/usr/bin/env bash
# `sphonic schema study` against the reader itself: what `study` takes conforms, what it refuses does not, and no key is missing.
#
#   schema_study.sh DRIVER REPOSITORY
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
"$driver" schema study >schema.json 2>err || code=$?
[[ $code == 0 && ! -s err ]] && ok "schema study ends with exit code 0 and no word on stderr" || failed "schema study" "exit code: $code" "$(<err)"
"$driver" schema >of_a_case.json
"$driver" schema case | cmp -s - of_a_case.json && ok "without a word it is that of a case" || failed "schema case"
code=0
"$driver" schema plan >/dev/null 2>err || code=$?
[[ $code == 2 && $(<err) == *plan* ]] && ok "there is no schema of anything else" || failed "schema plan" "exit code: $code" "$(<err)"

if ! command -v python3 >/dev/null; then
    echo "skipped what needs python3: there is none"
else
    python3 - "$driver" "$repository" <<'PYTHON' || failures=$((failures + 1))
import copy, glob, json, re, subprocess, sys

driver, repository = sys.argv[1:]
with open("schema.json") as file:
    schema = json.load(file)
failures = 0


def check(what, passed, why=""):
    global failures
    failures += not passed
    print("ok     " if passed else "FAILED ", what, "" if passed else why)


BASE = {
    "case": "case.json",
    "vary": [
        {"name": "dx", "pointer": "/particles/dx", "values": [0.1, 0.2]},
        {"name": "step", "family": True, "values": [{"label": 0.1, "set": {"/integrator/courant": 0.1}},
                                                    {"label": 0.2, "family": "long", "case": "case.json", "remove": ["/title"], "set": {}}]},
    ],
    "measure": "steps",
    "printed": {"columns": ["dx", "step", "steps"], "rows": [[0.1, 0.1, 3]]},
    "charts": [
        {"type": "cost", "name": "cost"},
        {"type": "value", "name": "line", "x": "dx"},
        {"type": "map", "name": "map", "x": "dx", "y": "step"},
    ],
}
ABSENT = object()


def edited(*edits):
    """BASE with each (path, value) put in place; a part of a path that is not there is made."""
    study = copy.deepcopy(BASE)
    for path, value in edits:
        at = study
        *parents, last = path
        for part in parents:
            at = at.setdefault(part, {}) if isinstance(at, dict) else at[part]
        if value is ABSENT:
            del at[last]
        else:
            at[last] = value
    return study


def refusal(study):
    """What the reader says; empty if it takes the study. Nothing is run."""
    with open("study.json", "w") as file:
        json.dump(study, file)
    read = subprocess.run([driver, "study", "study.json", "--launcher", "parallel", "--out", "jobs", "--force"], capture_output=True, text=True)
    return read.stderr.strip() if read.returncode else ""


with open("case.json", "w") as file:
    json.dump({"title": "a pulse", "dimension": 1, "medium": {"c0": 1, "rho0": 1}, "particles": {"type": "lattice", "dx": 0.1, "lower": [0], "upper": [2]},
               "kernel": {"type": "cubic_spline", "h_over_dx": 1}, "equations": "linear_acoustics", "initial": {"p": "exp(-x^2)"},
               "integrator": {"type": "leapfrog", "courant": 0.3}, "until": 0.1}, file)

# The reader tells its keys where one is nothing like any of them.
STRANGE = "qqqqqqqqqqqqqqqq"
dimension = schema["properties"]["vary"]["items"]
charts = {rule["if"]["properties"]["type"]["const"]: rule["then"] for rule in schema["properties"]["charts"]["items"]["allOf"]}
objects = {
    (): schema, ("vary", 0): dimension, ("vary", 1, "values", 0): dimension["properties"]["values"]["items"]["then"],
    ("printed",): schema["properties"]["printed"],
    ("charts", 0): charts["cost"], ("charts", 1): charts["value"], ("charts", 2): charts["map"],
}
for path, described in objects.items():
    said = refusal(edited((path + (STRANGE,), 1)))
    known = re.search(r"Known here: (.*)$", said)
    keys = set(known.group(1).split(", ")) if known else said
    check(f"the keys of /{'/'.join(map(str, path))} are the reader's", keys == set(described["properties"]), f"\n        reader: {keys}\n        schema: {set(described['properties'])}")
    said = [key for key, member in described["properties"].items() if "description" not in member]
    check(f"each of /{'/'.join(map(str, path))} is described", not said, said)
measures = re.search(r"is not one of (.*)$", refusal(edited((("measure",), STRANGE))))
check("so are the measures", measures and measures.group(1).split(", ") == schema["properties"]["measure"]["anyOf"][0]["enum"])

try:
    import jsonschema
except ImportError:
    print("skipped validation: python3 has no jsonschema")
    sys.exit(failures > 0)
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)


def complaint(study):
    error = jsonschema.exceptions.best_match(validator.iter_errors(study))
    return f"{error.json_path}: {error.message}" if error else ""


# A failure atlas, which has rows instead of what varies, is no study.
shipped = []
for path in sorted(glob.glob(repository + "/cases/**/studies/*.json", recursive=True)):
    with open(path) as file:
        study = json.load(file)
    if "rows" in study:
        continue
    shipped.append(path)
    check(f"{path.removeprefix(repository + '/')} conforms", not complaint(study), complaint(study))
check("studies are shipped", shipped)

COST, LINE, MAP = ("charts", 0), ("charts", 1), ("charts", 2)
PLAIN, LABELLED = ("vary", 0), ("vary", 1, "values", 0)
LOGS = [(LINE + ("x_log",), True), (LINE + ("y_log",), True)]
HERE = {"label": 0.3, "case": "case.json"}
BARE = [("vary", 0, "values"), [{"label": 0.1, "case": "case.json"}, HERE]]

# One change of BASE a row. The reader says which are right: this table does not.
changes = [
    [],
    # the study
    [(("$schema",), "study.schema.json")], [(("$schema",), 1)], [(("case",), ABSENT)], [(("case",), 1)], [(("case",), "")], [(("case",), ABSENT), BARE], [(("case",), ""), BARE],
    [(("case",), ABSENT), (LABELLED + ("case",), "case.json")], [(("titel",), "a")], [(("title",), "a")], [(("title",), 1)], [(("description",), "a")], [(("description",), [])],
    [(("measure",), "errors.l3")], [(("measure",), ["steps", "cpu_s"])], [(("measure",), ["steps", "steps"])],
    [(("measure",), [])], [(("measure",), ["steps", 1])], [(("measure",), 1)],
    [(("repeat",), 3)], [(("repeat",), 3.0)], [(("repeat",), 0)], [(("repeat",), 1001)], [(("repeat",), 1.5)], [(("repeat",), "3")],
    [(("cutoff",), 2)], [(("cutoff",), 0)], [(("cutoff",), "2 s")], [(("targets",), [0.1, 3])], [(("targets",), [])], [(("targets",), [0])], [(("targets",), 0.1)], [(("targets",), ["1 %"])],
    [(("worst_over",), "")], [(("worst_over",), 1)], [(("vary",), ABSENT)], [(("vary",), [])], [(("vary",), {})], [(("vary", 0), 1)],
    # dimensions
    [(PLAIN + ("name",), ABSENT)], [(PLAIN + ("name",), "")], [(PLAIN + ("name",), 1)], *[[(("printed",), ABSENT), (("charts",), ABSENT), (PLAIN + ("name",), name)] for name in ("h", "family", "cpu_s", "/h", "h/dx")],
    [(PLAIN + ("pointer",), ABSENT)], [(PLAIN + ("pointer",), [])], [(PLAIN + ("pointer",), 1)], [(PLAIN + ("pointer",), "particles")], [(PLAIN + ("pointer",), "/particles/")], [(PLAIN + ("pointer",), "/particles/~2")],
    [(PLAIN + ("pointer",), ["/particles/dx", 1])], [(PLAIN + ("pointer",), ["/particles/dx", "/until"])], [(PLAIN + ("family",), False)], [(PLAIN + ("family",), "dx")], [(PLAIN + ("familly",), True)],
    [(PLAIN + ("values",), [])], [(PLAIN + ("values",), 0.1)], [(PLAIN + ("values",), ABSENT)], [(PLAIN + ("values", 1), None)], [(PLAIN + ("values", 1), [0.2])], [(PLAIN + ("values", 1), {"label": 0.2})],
    [(("vary", 1, "pointer"), "/until")], [(("vary", 1, "values", 0), 0.1)],
    # values
    [(LABELLED + ("label",), ABSENT)], [(LABELLED + ("label",), [])], [(LABELLED + ("label",), None)], [(LABELLED + ("label",), True), (("printed",), ABSENT), (("charts", 2), ABSENT)],
    [(LABELLED + ("family",), "a")], [(LABELLED + ("family",), True)], [(LABELLED + ("case",), 1)], [(LABELLED + ("remove",), "/title")], [(LABELLED + ("remove",), [])], [(LABELLED + ("remove",), [1])],
    [(LABELLED + ("remove",), ["title"])], [(LABELLED + ("remove",), ["/title"])], [(LABELLED + ("set",), [])], [(LABELLED + ("set",), {"until": 0.1})], [(LABELLED + ("set",), {"/until": 0.2})],
    [(LABELLED + ("sets",), {})], [(LABELLED + ("pointer",), "/until")],
    # printed values
    [(("printed",), ABSENT)], [(("printed",), [])], [(("printed", "source"), "a")], [(("printed", "source"), 1)], [(("printed", "columns"), ABSENT)], [(("printed", "columns"), [])], [(("printed", "columns"), ["dx", 1])],
    [(("printed", "rows"), ABSENT)], [(("printed", "rows"), [])], [(("printed", "rows"), [3])], [(("printed", "row"), [])],
    # charts
    [(("charts",), ABSENT)], [(("charts",), [])], [(("charts",), {})], [(("charts", 0), "cost")],
    *[[(chart + (key,), value)] for chart in (COST, LINE, MAP) for key, value in
      (("type", ABSENT), ("type", "bar"), ("type", 1), ("name", ABSENT), ("name", ""), ("name", "a chart"), ("name", "a-chart_2"), ("title", "a"), ("title", 1), ("x_label", "a"), ("x_label", 1),
       ("y_label", 1), ("x_log", True), ("x_log", 1), ("y_log", True), ("y_log", "yes"), ("measure", "steps"), ("measure", "errors.l3"), ("y", "dt"), ("y", "step"), ("y", "errors.l3"), ("x", ABSENT), ("x", ""), ("x", 1),
       ("series", "step"), ("series", ""), ("series", 1), ("family", "step"), ("family", ""), ("family", 1), ("y_floor", 1e-3), ("y_floor", -1), ("y_floor", "0"), ("order", 0), ("order", 2), ("slopes", False), ("slopes", True), ("colour", "red"))
      if (chart, key, value) not in ((COST, "x", ABSENT), (MAP, "y", "errors.l3"))],
    *[LOGS[:n] + [(LINE + edit, value)] for n in (1, 2) for edit, value in ((("order",), 2), (("order",), 21), (("order",), "2"), (("slopes",), True), (("slopes",), 1))],
    [(LINE + ("x",), "/particles/dx")],
]
taken = 0
for edits in changes:
    study = edited(*edits)
    told, said = refusal(study), complaint(study)
    shown = ", ".join(f"/{'/'.join(map(str, path))} = {'(none)' if value is ABSENT else json.dumps(value)}" for path, value in edits)
    taken += not told
    check(f"study and the schema agree on {shown or 'the study'}", (not told) == (not said), f"\n        study:  {told[-200:] or 'takes it'}\n        schema: {said[:200] or 'takes it'}")
check("both take and refuse some", 0 < taken < len(changes))
check("a key with a typo is named", "'titel' was unexpected" in complaint(edited((("titel",), "a"))))
check("so is one in a chart", "'colour' was unexpected" in complaint(edited((LINE + ("colour",), "red"))))
check("a wrong type is named", complaint(edited((("cutoff",), "2 s"))).startswith("$.cutoff: '2 s'"))
sys.exit(failures > 0)
PYTHON
fi

((failures == 0)) || { echo "$failures checks failed"; exit 1; }
echo "all checks passed"
