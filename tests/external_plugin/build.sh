#!/usr/bin/env bash
# A project of its own builds a kernel and a viscosity against an installed sphonic, and the installed driver runs them.
#
#   build.sh BUILD_FOLDER REPOSITORY
set -euo pipefail

build=$(readlink -f -- "$1")
repository=$(readlink -f -- "$2")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

cmake --install "$build" --prefix "$scratch/installed" >"$scratch/install.log"
cp -r -- "$repository/tests/external_plugin/project" "$scratch/project"
cd -- "$scratch/project"
cmake -G Ninja -B out -DCMAKE_PREFIX_PATH="$scratch/installed" -DCMAKE_BUILD_TYPE=Release >"$scratch/configure.log"
cmake --build out >"$scratch/build.log"

sphonic=$scratch/installed/bin/sphonic
"$sphonic" describe kernel outside_quartic --plugin-path out/plugins
cp -- "$repository/cases/li2015/propagation.json" .
"$sphonic" run propagation.json --plugin-path out/plugins --out result --set /until=0.01 --set /particles/motion=frozen \
    --set /integrator/type=symplectic_euler --set '/kernel={"type":"outside_quartic","h":0.13}' \
    --set '/viscosity={"type":"outside_linear","alpha":0.06}'
[[ -s result/summary.json ]]
SPHONIC_PLUGIN_PATH=$scratch/project/out/plugins "$build/bin/test_contract" -w NoTests
