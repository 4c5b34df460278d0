#!/usr/bin/env bash
# `sphonic new`: what it writes for every kind compiles without a warning, loads, obeys the laws, and goes into a case.
#
#   new.sh DRIVER BUILD REPOSITORY
# shellcheck disable=SC2015,SC2001  # ok and failed always succeed; sed unescapes
set -euo pipefail

driver=$(readlink -f -- "$1")
build=$(readlink -f -- "$2")
repository=$(readlink -f -- "$3")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
# shellcheck source=tests/driver/report.sh
source "$repository/tests/driver/report.sh"
cd -- "$scratch"
unset SPHONIC_PLUGIN_PATH
mkdir sources plugins

# expect WHAT CODE PATTERN ARGUMENTS...: exit code, and stdout or stderr, whichever has something.
expect() {
    local what=$1 code=0 said
    said=$("$driver" "${@:4}" 2>&1 </dev/null) || code=$?
    # shellcheck disable=SC2053  # a pattern
    [[ $code == "$2" && $said == $3 ]] && ok "$what" || failed "$what" "exit code: $code, expected $2" "said:     $said" "expected: $3"
}

# compile KIND SOURCE LIBRARY: as the build compiles a plugin of that kind, and links it.
compile() {
    local command
    command=$(sed -n 's|^ *"command": "\(.*\) -o plugins/CMakeFiles/'"$1"'\.[^ ]* -c .*|\1|p' "$build/compile_commands.json" | sed -e 1q)
    [[ -n $command ]] || { echo "no plugin of the kind $1 in $build/compile_commands.json"; return 1; }
    command=$(sed 's/\\\(.\)/\1/g' <<<"$command")    # JSON's escapes; what remains is the shell's
    (eval "$command -Werror -shared -o \"\$3\" \"\$2\"") 2>&1
}

kinds=$("$driver" list | grep '^[a-z]')
for kind in $kinds; do
    echo "--- $kind"
    expect "new $kind says what it wrote and what comes next" 0 "sources/${kind}_sample.cpp"$'\n'"Next:"$'\n'*"describe $kind ${kind}_sample"* \
        new "$kind" "${kind}_sample" --dir sources
    said=$(compile "$kind" "sources/${kind}_sample.cpp" "plugins/$kind.${kind}_sample.so") \
        && ok "it compiles" || failed "it compiles" "$said"
    expect "it describes itself" 0 "$kind ${kind}_sample: *" describe "$kind" "${kind}_sample" --plugin-path plugins
    said=$("$driver" new "$kind" "${kind}_sample" --dir "$(mktemp -d -p .)" --json)
    member() { sed -n 's/^ *"'"$1"'": "\(.*\)",$/\1/p' <<<"$said" | sed 's/\\\(.\)/\1/g'; }
    set=$(member set) scene=$(member scene)
    expect "it runs in a case" 0 "*results in out_$kind*" \
        run "$repository/$scene" --plugin-path plugins --set "$set" --set /until=0.002 --out "out_$kind"
done

echo "--- laws"
if [[ -x $build/bin/test_contract ]]; then
    said=$(SPHONIC_PLUGIN_PATH=$PWD/plugins "$build/bin/test_contract" 2>&1) \
        && ok "what new writes obeys the contract tests" || failed "what new writes obeys the contract tests" "$said"
else
    echo "skipped the contract tests: $build/bin/test_contract is not built"
fi

echo "--- a kernel of two dimensions only"
sed -e 's/dimensions(1, 2, 3)/dimensions(2)/' -e 's/kernel_sample/flat_sample/' sources/kernel_sample.cpp >sources/flat_sample.cpp
said=$(compile kernel sources/flat_sample.cpp plugins/kernel.flat_sample.so) && ok "it compiles" || failed "it compiles" "$said"
expect "and is refused in one" 2 \
    '*propagation.json: /kernel/type: this kernel is not defined in dimension 1. Choose another kernel' \
    check "$repository/cases/li2015/propagation.json" --plugin-path plugins --set /kernel/type=flat_sample

echo "--- in a source tree"
mkdir -p tree/plugins/kernels tree/core/include/sphonic/plugin tree/cases
touch tree/plugins/CMakeLists.txt
cd tree/cases
expect "the source goes to the kind's folder, from anywhere in the tree" 0 \
    '../plugins/kernels/mine.cpp'$'\n'*'../apps/sphonic describe kernel mine*../apps/sphonic check li2015/propagation.json --set /kernel/type=mine*' \
    new kernel mine
cd ../..
cmp -s <(sed -e 's/kernel_sample/mine/' -e 's/KernelSample/Mine/g' sources/kernel_sample.cpp) tree/plugins/kernels/mine.cpp \
    && ok "and differs from another only in its name" || failed "and differs from another only in its name"

echo "--- refused"
echo precious >sources/taken.cpp
ln -s nowhere sources/link.cpp
expect "a file that exists" 5 '*sources/taken.cpp: exists already. Choose another name' new kernel taken --dir sources
[[ $(<sources/taken.cpp) == precious ]] && ok "and it is left as it was" || failed "and it is left as it was"
expect "a link that leads nowhere" 5 '*sources/link.cpp: exists already*' new kernel link --dir sources
expect "a known plugin's name" 2 '*there is a kernel "gaussian" already, in /*kernel.gaussian.so. Choose another name' new kernel gaussian --dir sources
expect "another path's plugin's name" 2 '*already, in /*plugins/form.form_sample.so*' new form form_sample --dir sources --plugin-path plugins
for name in Gaussian my-kernel 2nd _mine mine_ a__b 'a b' ../mine ""; do
    expect "the name \"$name\"" 2 '*is not a plugin'"'"'s name. Use lower_snake_case*' new kernel "$name" --dir sources
done
expect "an unknown kind" 2 '*there is no plugin kind "kernal". Did you mean "kernel"?' new kernal mine --dir sources
expect "a folder that is not there" 2 '*--dir: nofolder is not a folder*' new kernel mine --dir nofolder
expect "no folder outside a source tree" 2 '*this folder is not in a source tree of sphonic. Go there, or give --dir' new kernel mine
if [[ $(id -u) != 0 ]]; then
    mkdir -m 555 readable
    expect "a folder that cannot be written to" 5 '*readable/mine.cpp: cannot be written: Permission denied*' new kernel mine --dir readable
fi
expect "a name too long for a file" 5 '*cannot be written*' new kernel "$(printf 'a%.0s' {1..300})" --dir sources

((failures == 0)) || { echo "$failures checks failed"; exit 1; }
echo "all checks passed"
