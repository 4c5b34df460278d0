#!/usr/bin/env bash
# What a user sees of the driver when something is wrong: exit code, message, and nothing left behind.
#
#   errors.sh DRIVER REPOSITORY
#
# refused, refused_like, refused_edit, refused_text: a case that check and run must both refuse in the same words.
# misused: a command line. *_like and misused take a pattern, the others the whole message.
# A new row of a table is one line. All rows start from the case below, which runs without a word on stderr.
# shellcheck disable=SC2015,SC2016,SC2059  # ok and failed always succeed; JSON in quotes; texts are formats
set -euo pipefail

driver=$(readlink -f -- "$1")
repository=$(readlink -f -- "$2")
scratch=$(mktemp -d)
trap 'chmod -R u+rwx -- "$scratch"; rm -rf -- "$scratch"' EXIT
# shellcheck source=tests/driver/report.sh
source "$repository/tests/driver/report.sh"
cd -- "$scratch"
unset SPHONIC_PLUGIN_PATH
mkdir parent plugins

cat >case.json <<'CASE'
{
  "title": "A short wave",
  "dimension": 1,
  "medium": { "c0": 340, "rho0": 1.0 },
  "particles": { "type": "lattice", "dx": 0.04, "lower": [-1], "upper": [4], "motion": "frozen" },
  "kernel": { "type": "cubic_spline", "h": 0.04 },
  "equations": "linear_acoustics",
  "sources": [ { "type": "plane_wave", "region": "x < 0", "amplitude": 50, "omega": 500, "direction": [1] } ],
  "integrator": { "type": "symplectic_euler", "courant": 0.5 },
  "until": 0.005,
  "reference": { "type": "plane_wave_front", "region": "0 <= x <= 4" },
  "output": { "every": 0.001, "probes": [[2.0]] }
}
CASE

# Leaves $code, $out and $err; the colour and the "error: " of the log are taken off.
sphonic() {
    code=0
    timeout 20 "$driver" "$@" >out 2>err </dev/null || code=$?
    out=$(<out)
    err=$(sed -e 's/\x1b\[[0-9;]*m//g' -e 's/^error: //' err)
}

# compare WHAT CODE exactly|like MESSAGE: the last call's exit code and stderr, an empty stdout, an empty output parent.
compare() {
    local what=$1 complaints=()
    [[ $code == "$2" ]] || complaints+=("exit code: $code, expected $2")
    if [[ $3 == like ]]; then
        # shellcheck disable=SC2053  # a pattern
        [[ $err == $4 ]] || complaints+=("stderr:   $err" "expected: $4")
    else
        [[ $err == "$4" ]] || complaints+=("stderr:   $err" "expected: $4")
    fi
    [[ -z $out ]] || complaints+=("stdout is not empty: ${out:0:200}")
    [[ -z $(ls -A parent) ]] || complaints+=("left behind in the output's parent: $(ls -A parent)")
    rm -rf parent/* parent/.[!.]*
    if ((${#complaints[@]})); then failed "$what" "${complaints[@]}"; else ok "$what"; fi
}

# Both subcommands that read a case must refuse it in the same words.
both() {
    local how=$1 expected=$2 message=$3 file=$4
    shift 4
    sphonic check "$file" "$@"
    compare "check $file $*" "$expected" "$how" "$message"
    sphonic run "$file" --out parent/out "$@"
    compare "run $file $*" "$expected" "$how" "$message"
}

# refused CODE MESSAGE [OPTIONS...]: the case with these options.
refused() { both exactly "$1" "$2" case.json "${@:3}"; }
# refused_like CODE PATTERN [OPTIONS...]
refused_like() { both like "$1" "$2" case.json "${@:3}"; }
# refused_edit MESSAGE SED_SCRIPT: the case's text after an edit; the message names edited.json.
refused_edit() {
    sed -e "$2" case.json >edited.json
    both exactly 2 "$1" edited.json
}
# refused_text MESSAGE TEXT: a file of this text (printf's escapes); the message names text.json.
refused_text() {
    printf "$2" >text.json
    both exactly 2 "$1" text.json
}
# misused CODE PATTERN ARGUMENTS...: the command line itself.
misused() {
    sphonic "${@:3}"
    compare "${*:3}" "$1" like "$2"
}
# terms TERM: equations whose pressure has this one term.
terms() { printf '/equations={"p":[%s],"rho":{"state":"total_density","of":"p"},"u":[{"gradient":"p","form":"sum"}]}' "$1"; }
# times PRODUCT: equations whose divergence is multiplied by it.
times() { terms '{"divergence":"u","form":"difference","times":"'"$1"'"}'; }

echo "--- names"
refused 2 'case.json: /kernel/typ: unknown key "typ". Did you mean "type"?' --set /kernel/typ=gaussian
refused 2 'case.json: /kernel/typ: unknown key "typ". Did you mean "type"?' --set '/kernel={"typ":"cubic_spline","h":0.04}'
refused 2 'case.json: /methd: unknown key "methd". Did you mean "method"?' --set '/methd={"type":"fdtd"}'
refused 2 'case.json: /reference/regoin: unknown key "regoin". Did you mean "region"?' --set '/reference={"type":"plane_wave_front","regoin":"x > 0"}'
refused 2 'case.json: /kernel/type: there is no kernel named "cubic_splin". Did you mean "cubic_spline"?' --set /kernel/type=cubic_splin
refused_like 2 'case.json: /kernel/type: there is no kernel named "sponge". Known: *cubic_spline, gaussian, *quintic_spline*' --set /kernel/type=sponge
refused_like 2 'case.json: /equations: there are no equations named "linear_acustics". *linear_acoustics*' --set /equations=linear_acustics
refused 2 'case.json: /particles/motion: "frozn" is not one of auto, frozen, lagrangian. Did you mean "frozen"?' --set /particles/motion=frozn

echo "--- values"
refused 2 'case.json: /kernel/h: -1 is out of range. h [m] must be greater than 0' --set /kernel/h=-1
refused 2 'case.json: /kernel: h and h_over_dx are both given. Give one of h [m] and h_over_dx' --set /kernel/h_over_dx=1
refused 2 'case.json: /kernel: the smoothing length is missing. Give one of h [m] and h_over_dx' --set '/kernel={"type":"cubic_spline"}'
refused 2 'case.json: /kernel/h: the support of 0.02 m reaches no neighbour. Choose h so that support * h > dx' --set /kernel/h=0.01
refused 2 'case.json: /medium/rho0: is missing. rho0 [kg/m^3] must be greater than 0' --set '/medium={"c0":340}'
refused 2 'case.json: /medium/c0: "fast" is not a number. Give a number' --set /medium/c0=fast
refused 2 'case.json: /title: 3 is not a string. Give a string' --set /title=3
refused 2 'case.json: /sources: {} is not a list. Write [ { "type": ... } ]' --set '/sources={}'
refused 2 'case.json: /dimension: 4 is not a dimension. Give 1, 2 or 3' --set /dimension=4
refused 2 'case.json: /dimension: 4294967297 is not a dimension. Give 1, 2 or 3' --set /dimension=4294967297
refused 2 'case.json: /particles/lower: [-1,0] does not fit dimension 1. Give a list of 1 number' --set /particles/lower=[-1,0]
refused 2 'case.json: /particles/upper: upper is not above lower along axis x. Give upper > lower' --set /particles/upper=[-2]
refused_like 2 'case.json: /particles/dx: the box holds * particles, which need at least * GB; * GB are free. Choose a larger dx or a smaller box' --set /particles/dx=1e-15
refused_like 2 'case.json: /particles/dx: the periodic axis x is 71.42* spacings long. Choose dx or upper so that (upper - lower)/dx is an integer' --set '/boundaries=[{"type":"periodic","face":"x"}]' --set /particles/dx=0.07
refused 2 'case.json: /boundaries: only one face of the axis x is periodic. Give the axis as face: "x"' --set '/boundaries=[{"type":"periodic","face":"x_min"}]'
refused 2 'case.json: /integrator/courant: dt and courant are both given. Give one of dt, courant and safety' --set /integrator/dt=1e-5
refused_like 2 'case.json: /integrator/courant: the step * s (c0 dt/dx = 2.*) is beyond the stable limit * s (c0 dt/dx = *). Choose a smaller step, or set "unstable": "allow" to study the failure' --set /integrator/courant=3

echo "--- regions and equations"
refused 2 'case.json: /sources/0/region: no particle lies in "x < -100". Choose a region inside the box' --set '/sources/0/region=x < -100'
refused 2 'case.json: /reference/region: no particle lies in "x > 100". Choose a region inside the box' --set '/reference/region=x > 100'
refused 2 'case.json: /sources/0/region: "x <": something is missing at the end. Complete it' --set '/sources/0/region=x <'
refused 2 'case.json: /sources/0/region: "y < 0": "y" does not exist in 1-D. Use x or r' --set '/sources/0/region=y < 0'
refused 2 'case.json: /sources/0/region: "0 <= x > -1": "<=" and ">" do not chain. Join two comparisons with and' --set '/sources/0/region=0 <= x > -1'
refused 2 'case.json: /sources/0/region: "x": this is a number, not a condition. Compare it with a number' --set '/sources/0/region=x'
refused 2 'case.json: /equations/p/0/divergence: there is no variable "v". The equations have p, rho, u' --set "$(terms '{"divergence":"v","form":"difference"}')"
refused 2 'case.json: /equations/p/0: the term has no operator. Give exactly one of divergence, gradient, viscosity' --set "$(terms '{"form":"difference"}')"
refused 2 'case.json: /equations/p/0/form: there is no form named "diference". Did you mean "difference"?' --set "$(terms '{"divergence":"u","form":"diference"}')"
refused 2 'case.json: /equations/p/0/times: "rho1": "rho1" is unknown. Did you mean "rho0"?' --set "$(times '-rho1*c0^2')"
refused 2 'case.json: /equations/p/0/times: "1-2*c0^2" is not a product. Write factors joined by * and /' --set "$(times '1-2*c0^2')"
refused 2 'case.json: /equations/p/0/times: "rho^" is not an integer power. Powers of variables are integers' --set "$(times '-rho^')"
refused 2 'case.json: /equations/p/0/times: "rho^99999999999" is not an integer power. Powers of variables are integers' --set "$(times '-rho^99999999999')"
refused_like 2 'case.json: /equations/p/0/times: "x": "x" is a coordinate*' --set "$(times '-c0^2*x')"
refused_like 2 'case.json: /equations/p/0/times: "r": "r" is a coordinate*' --set "$(times '-c0^2*r')"
refused_like 2 'case.json: /equations/p/0/times: *2 3*' --set "$(times '-2 3*c0^2')"
refused_like 2 'case.json: /equations/p/of: *' --set '/equations={"p":{"state":"acoustic","of":"p"},"u":[{"gradient":"p","form":"sum"}]}'

echo "--- text"
refused_text 'text.json:1:1: the text is empty. Write a JSON value' ''
refused_text 'text.json:1:1: "hello" is not JSON. Correct the JSON there' 'hello'
refused_text 'text.json:1:1: the text begins with a byte-order mark. Save it as UTF-8 without one' '\xef\xbb\xbf{}'
refused_text 'text.json: /: [] is not an object. Write { ... } here' '[]'
refused_text 'text.json: /dimension: is missing. Give 1, 2 or 3' '{}'
refused_edit 'edited.json: /until: the key "until" is given twice. Remove one of them' 's/"until": 0.005/&, "until": 0.5/'
refused_edit 'edited.json:10:12: "NaN" is not JSON. Write a finite number' 's/"until": 0.005/"until": NaN/'
refused_edit 'edited.json: /until: the number 1e999 is too large for a double. Write a smaller number' 's/"until": 0.005/"until": 1e999/'
refused_edit "edited.json:13:1: unexpected end of input, expected '}'. Correct the JSON there" '$d'

echo "--- files and plugins"
both exactly 2 'nowhere.json: there is no such file. Check the path' nowhere.json
echo 'not a library' >plugins/kernel.fake.so
refused 4 "$scratch/plugins/kernel.fake.so: is not a shared library (no ELF header). Build the plugin as a shared library" --plugin-path plugins --set /kernel/type=fake
refused 4 'nofolder: this plugin folder does not exist. Give an existing folder to --plugin-path or SPHONIC_PLUGIN_PATH' --plugin-path nofolder
mkdir precious && echo years >precious/thesis
misused 5 'precious: exists already. Give --force to replace it, or another --out' run case.json --out precious
misused 5 'precious: holds something other than *. Give another --out' run case.json --out precious --force
[[ -f precious/thesis ]] && ok "a folder without results outlives --force" || failed "a folder without results outlives --force"
if [[ $(id -u) == 0 ]]; then
    echo "skipped unwritable folders: root may write anywhere"
else
    mkdir -m 555 readable && mkdir -m 000 closed
    misused 5 'readable/out: cannot be created: Permission denied. Check space and permissions' run case.json --out readable/out
    misused 5 'closed/out: cannot be created: Permission denied. Check space and permissions' run case.json --out closed/out
fi
sphonic run case.json --set /integrator/courant=3
[[ ! -e runs ]] && ok "a refused run leaves no runs folder" || failed "a refused run leaves no runs folder"
rm -rf runs

echo "--- command line"
misused 2 '*frobnicate*' frobnicate
misused 2 '*--frobnicate*' check case.json --frobnicate
misused 2 '*CASE is required*' run
misused 2 '--set: "/until" has no "=". Write /pointer=value' check case.json --set /until
misused 2 '--set: "until" does not point to a member. *' check case.json --set until=1
misused 2 'describe: there is no plugin kind "colour". Known: *' describe colour blue
misused 2 'describe: there is no kernel named "cubic_splin". Did you mean "cubic_spline"?' describe kernel cubic_splin

code=0
"$driver" check case.json >/dev/full 2>err || code=$?
[[ $code == 5 ]] && ok "a result that cannot be written is an error" || failed "a result that cannot be written is an error" "exit code: $code, expected 5"

echo "--- and what is right"
sphonic check case.json
[[ $code == 0 && -z $err ]] && ok "the case of this test is sound" || failed "the case of this test is sound" "$code" "$err"

sphonic run case.json --out diverged --set /integrator/courant=3 --set /integrator/unstable=allow --set /until=0.5
[[ $code == 3 && $err == *'case.json: the run diverged at t = '*'; the outputs until then are kept' && -s diverged/summary.json ]] \
    && ok "a run that diverges ends with exit code 3 and keeps its outputs" \
    || failed "a run that diverges ends with exit code 3 and keeps its outputs" "exit code: $code" "stderr: $err"

if command -v python3 >/dev/null; then
    for command in "check case.json" "run case.json --out json" "list" "describe kernel gaussian"; do
        # shellcheck disable=SC2086  # words
        sphonic $command --json
        [[ $code == 0 ]] && python3 -c 'import json, sys; json.load(sys.stdin)' <out 2>parse \
            && ok "$command --json is JSON" || failed "$command --json is JSON" "exit code: $code" "$(tail -n 1 parse)"
    done
else
    echo "skipped --json: there is no python3"
fi

sphonic run "$repository/cases/li2015/propagation.json" --set /until=0.005 --out first
sphonic run first/resolved.json --out second
cmp -s first/profile.csv second/profile.csv && cmp -s first/resolved.json second/resolved.json \
    && ok "resolved.json runs again to the same bits" || failed "resolved.json runs again to the same bits" "exit code: $code" "$err"

((failures == 0)) || { echo "$failures checks failed"; exit 1; }
echo "all checks passed"
