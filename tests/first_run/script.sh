#!/usr/bin/env bash
# apps/sphonic with every tool it calls replaced by a fake: no build, no network, no rights needed.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
failures=0

# The only tools on the script's PATH: the real ones it may use, then fakes.
real_tools=(bash cat env flock mkdir nproc printf readlink rm sha256sum tail tee true)

fake() {
    local file=$box/bin/$1
    { printf '#!%s\n' "$BASH"; cat; } >"$file"
    chmod +x "$file"
}

# A fresh tree, all packages installed, an ordinary user without sudo. Stubs note their arguments in $box/calls.
fresh_box() {
    box=$(mktemp -d -p "$scratch" "a box.XXXX")    # with a space: paths are quoted or this fails
    mkdir -p "$box/bin" "$box/tree/apps" "$box/elsewhere"
    cp "$root/apps/sphonic" "$box/tree/apps/"
    cp "$root/CMakePresets.json" "$box/tree/"
    local tool
    for tool in "${real_tools[@]}"; do ln -s "$(type -P "$tool")" "$box/bin/$tool"; done
    export box absent="" uid=1000 broken=""
    fake id <<'FAKE'
echo "$uid"
FAKE
    fake dpkg-query <<'FAKE'
echo dpkg-query >>"$box/calls"
shift 2
for package in "$@"; do
    case " $absent gnuplot-qt gnuplot-x11 " in
    *" $package "*) status=1 ;;
    *) echo "installed $package" ;;
    esac
done
exit "${status:-0}"
FAKE
    fake apt-get <<'FAKE'
echo "apt-get $*" >>"$box/calls"
echo "chatter of apt-get"
FAKE
    fake cmake <<'FAKE'
echo "cmake $*" >>"$box/calls"
echo "chatter of cmake"
echo "more chatter of cmake" >&2
if [[ $1 == --preset ]]; then [[ -f CMakePresets.json && $broken != configure ]]; exit; fi
if [[ $broken == build ]]; then
    for ((i = 1; i <= 100; ++i)); do echo "[$i/100] line $i of the build"; done
    echo "fatal: no such header"
    exit 1
fi
mkdir -p "$box/tree/build/release/bin"
{
    echo "#!$BASH"
    echo 'echo "driver in $PWD"; (($# == 0)) || printf "<%s>\n" "$@"; exit "${driver_status:-0}"'
} >"$box/tree/build/release/bin/sphonic"
/bin/chmod +x "$box/tree/build/release/bin/sphonic"
FAKE
    fake ctest <<'FAKE'
echo "ctest $*" >>"$box/calls"
exit "${ctest_status:-0}"
FAKE
    fake ninja <<<'exit 0'
    fake g++ <<<'exit 0'
}

# Runs the script in the box; leaves $status, $box/out and $box/err.
sphonic() {
    status=0
    : >"$box/calls"
    (cd "$box/elsewhere" && PATH=$box/bin exec "${entrance:-$box/tree/apps/sphonic}" "$@") \
        </dev/null >"$box/out" 2>"$box/err" || status=$?
}

check() {
    local what=$1
    shift
    if "$@"; then
        echo "ok      $what"
        return
    fi
    echo "FAILED  $what"
    failures=$((failures + 1))
    echo "--- status ${status:-}; calls, stdout, stderr:"
    cat -- "$box/calls" "$box/out" "$box/err"
    echo "---"
}

same() { [[ $1 == "$2" ]]; }
has() { grep -qF -- "$2" "$1"; }
lacks() { ! grep -qF -- "$2" "$1"; }
install_line() { grep -F ' install ' "$box/calls" || true; }

fresh_box
absent="libspdlog-dev gnuplot-nox"
sphonic list
check "missing packages without rights end with exit code 5" same "$status" 5
check "the message names the missing packages and the command" \
    has "$box/err" "apt-get install -y --no-install-recommends libspdlog-dev gnuplot-nox"
check "without rights nothing is installed or configured" same "$(<"$box/calls")" dpkg-query

fresh_box
absent="ninja-build catch2 libcli11-dev"
uid=0
sphonic list
check "root gets exactly the missing packages of the build, not those of the tests" \
    same "$(install_line)" "apt-get -o DPkg::Lock::Timeout=120 install -y --no-install-recommends --no-remove ninja-build libcli11-dev"
check "package lists are refreshed before the installation" has "$box/calls" "apt-get -o DPkg::Lock::Timeout=120 update"
check "stdout carries the driver's lines only" same "$(<"$box/out")" "driver in $box/elsewhere"$'\n'"<list>"
check "the log keeps the chatter" has "$box/tree/build/release/first-run.log" "more chatter of cmake"

absent=catch2
sphonic test -R door
check "the tests install what they need in addition" has "$box/calls" "--no-remove catch2"
check "the tests configure again after an installation" has "$box/calls" "cmake --preset release"
check "the tests build everything" has "$box/calls" "cmake --build $box/tree/build/release --target all"
check "the tests run the gate with the user's arguments" has "$box/calls" \
    "ctest --test-dir $box/tree/build/release -j$(nproc) -L gate --output-on-failure --no-tests=error -R door"
absent=""
sphonic list
check "the driver accepts the configuration made for the tests" lacks "$box/calls" "cmake --preset"
sphonic test -L slow
check "a label of the user's replaces the gate" lacks "$box/calls" "-L gate"
check "a label of the user's is passed on" has "$box/calls" "-L slow"
sphonic test -LE slow
check "an excluded label leaves the gate in place" has "$box/calls" "-L gate"
ctest_status=8 sphonic test
check "a failing test's exit code comes through" same "$status" 8

fresh_box
absent="git"
fake sudo <<'FAKE'
[[ $1 != -n ]] || shift
echo "sudo $*" >>"$box/calls"
exec "$@"
FAKE
sphonic list
check "sudo without a password installs" has "$box/calls" "sudo env DEBIAN_FRONTEND=noninteractive apt-get"
check "sudo installs exactly the missing package" has "$box/calls" "--no-remove git"
fake sudo <<<'exit 1'
rm -f "$box/tree/build/release/first-run.stamp"
sphonic list
check "sudo that wants a password is no right where nobody can type" same "$status" 5

fresh_box
sphonic run case.json
check "the first call configures" has "$box/calls" "cmake --preset release"
check "the driver needs its own target only" has "$box/calls" "--target sphonic_driver_all"
sphonic run case.json
check "the second call only builds" same "$(<"$box/calls")" \
    "cmake --build $box/tree/build/release --target sphonic_driver_all"
check "the second call says nothing" same "$(<"$box/err")" ""
sphonic run "my case.json" --set "/title=a  b" "" '*'
check "arguments pass through intact" same "$(<"$box/out")" \
    "driver in $box/elsewhere"$'\n<run>\n<my case.json>\n<--set>\n</title=a  b>\n<>\n<*>'
driver_status=3 sphonic run case.json
check "the driver's exit code comes through" same "$status" 3
sphonic
check "no arguments ask for help" has "$box/out" "<--help>"
ln -s ../tree/apps/sphonic "$box/elsewhere/link"
entrance=./link sphonic list
check "a symbolic link to the script works" has "$box/out" "<list>"
echo >>"$box/tree/CMakePresets.json"
sphonic list
check "changed presets are configured again" has "$box/calls" "cmake --preset release"

broken=build
sphonic list
check "a failing build ends with exit code 5" same "$status" 5
check "a failing build shows the end of the log" has "$box/err" "fatal: no such header"
check "a failing build shows no more than 40 lines of it" lacks "$box/err" "line 61 of the build"
check "a failing build shows the 40th line from the end" has "$box/err" "line 62 of the build"
check "a failing build names the log" has "$box/err" "$box/tree/build/release/first-run.log"
check "a failing build does not start the driver" same "$(<"$box/out")" ""
broken=""
sphonic list
check "after a failure packages and configuration are looked at again" has "$box/calls" "cmake --preset release"

fresh_box
broken=configure
sphonic list
check "a failing configuration ends with exit code 5" same "$status" 5
check "a failing configuration is not built" lacks "$box/calls" "--build"

fresh_box
mkdir "$box/tree/apps/report"
echo '{}' >"$box/tree/apps/report/package-lock.json"
sphonic list
check "without npm there is no word about it" lacks "$box/err" npm
fake npm <<'FAKE'
echo "npm $* in $PWD" >>"$box/calls"
exit "${npm_status:-0}"
FAKE
echo '{ }' >"$box/tree/apps/report/package-lock.json"
sphonic list
check "npm installs what a report's chart needs" has "$box/calls" "npm ci --ignore-scripts --no-audit --no-fund --omit=dev in $box/tree/apps/report"
sphonic list
check "npm is not asked again" lacks "$box/calls" npm
sphonic test
check "the tests need its browser driver too" has "$box/calls" "npm ci --ignore-scripts --no-audit --no-fund in"
echo '{  }' >"$box/tree/apps/report/package-lock.json"
npm_status=1 sphonic list
check "a failing npm is told" has "$box/err" "no interactive chart"
check "a failing npm stops nothing" has "$box/out" "<list>"

fresh_box
rm "$box/bin/dpkg-query" "$box/bin/ninja"
sphonic list
check "without dpkg a missing tool ends with exit code 5" same "$status" 5
check "without dpkg the missing tool is named" has "$box/err" "missing commands: ninja"

fresh_box
mkdir -p "$box/tree/build/release"
exec 8>"$box/tree/build/release/first-run.lock"
flock 8
sphonic list 8>&- &
waiting=$!
for ((i = 0; i < 100; ++i)); do
    grep -qs "waiting for another build" "$box/err" && break
    sleep 0.1
done
check "a second call waits for the first" same "$(<"$box/calls")" ""
check "a waiting call says so" has "$box/err" "waiting for another build"
exec 8>&-
wait "$waiting"
check "a waiting call goes on when the first is done" has "$box/out" "<list>"

((failures == 0)) || { echo "$failures checks failed"; exit 1; }
echo "all checks passed"
