#!/usr/bin/env bash
# What a user sees of the driver when something is wrong: exit code, message, and nothing left behind.
#
#   errors.sh DRIVER REPOSITORY
#
# refused, refused_like, refused_edit, refused_text: a case that check and run must both refuse in the same words.
# misused: a command line. *_like and misused take a pattern, the others the whole message.
# A new row of a table is one line. All rows start from the case below, which runs without a word on stderr.
# The tables stand in errors_in_cases.sh, errors_at_obstacles.sh, warnings_of_sources.sh, errors_in_outputs.sh,
# errors_in_steps.sh and errors_in_atlas.sh.
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

export XDG_CACHE_HOME=$PWD/cache    # not what this machine was once found to be
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

# The files out and err to $out and $err; the colour and the "error: " of the log are taken off, and what it tells by the way.
hear() {
    out=$(<out)
    err=$(sed -e 's/\x1b\[[0-9;]*m//g' -e 's/^error: //' -e '/^info: /d' err)
}
# Leaves $code, $out and $err.
sphonic() {
    code=0
    timeout 20 "$driver" "$@" >out 2>err </dev/null || code=$?
    hear
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
# refused_bare MESSAGE OPTIONS...: the case without its reference; the message names bare.json.
refused_bare() {
    sed -e '/"reference"/d' case.json >bare.json
    both exactly 2 "$1" bare.json "${@:2}"
}
# source_is OBJECT: one source in the others' place.
source_is() { printf '/sources=[%s]' "$1"; }
# terms TERM: equations whose pressure has this one term.
terms() { printf '/equations={"p":[%s],"rho":{"state":"total_density","of":"p"},"u":[{"gradient":"p","form":"sum"}]}' "$1"; }
# also MEMBER: linear equations and this member besides.
also() { terms '{"divergence":"u","form":"difference","times":"-rho0*c0^2"}' | sed "s/}\$/,$(sed 's/[&\/]/\\&/g' <<<"$1")}/"; }
# times PRODUCT: equations whose divergence is multiplied by it.
times() { terms '{"divergence":"u","form":"difference","times":"'"$1"'"}'; }

# shellcheck source=tests/driver/errors_in_cases.sh
source "$repository/tests/driver/errors_in_cases.sh"
# shellcheck source=tests/driver/errors_at_obstacles.sh
source "$repository/tests/driver/errors_at_obstacles.sh"
# shellcheck source=tests/driver/warnings_of_sources.sh
source "$repository/tests/driver/warnings_of_sources.sh"
# shellcheck source=tests/driver/errors_in_outputs.sh
source "$repository/tests/driver/errors_in_outputs.sh"
# shellcheck source=tests/driver/errors_in_steps.sh
source "$repository/tests/driver/errors_in_steps.sh"
# shellcheck source=tests/driver/errors_in_atlas.sh
source "$repository/tests/driver/errors_in_atlas.sh"
# shellcheck source=tests/driver/calibrate.sh
source "$repository/tests/driver/calibrate.sh"

((failures == 0)) || { echo "$failures checks failed"; exit 1; }
echo "all checks passed"
