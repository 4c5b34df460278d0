# Sourced by errors.sh: files, outputs, the command line, and what is right.
# shellcheck shell=bash disable=SC2154,SC2015,SC2016  # of errors.sh; ok and failed always succeed; JSON and scripts in quotes

echo "--- files and plugins"
both exactly 2 'nowhere.json: there is no such file. Check the path' nowhere.json
echo 'not a library' >plugins/kernel.fake.so
refused 4 "$scratch/plugins/kernel.fake.so: is not a shared library (no ELF header). Build the plugin as a shared library" --plugin-path plugins --set /kernel/type=fake
refused 4 'nofolder: this plugin folder does not exist. Give an existing folder to --plugin-path or SPHONIC_PLUGIN_PATH' --plugin-path nofolder

echo "--- outputs"
mkdir precious && echo years >precious/thesis
misused 5 'precious: exists already. Give --force to replace it, or another --out' run case.json --out precious
misused 5 'precious: holds something other than *. Give another --out' run case.json --out precious --force
[[ $(<precious/thesis) == years && $(ls -A precious) == thesis ]] && ok "a folder without results outlives --force" || failed "a folder without results outlives --force"
sphonic run case.json --out kept
before=$(cd kept && cksum ./*)
misused 5 'kept: exists already. Give --force to replace it, or another --out' run case.json --out kept --set /until=0.001
[[ $(cd kept && cksum ./*) == "$before" ]] && ok "results are not overwritten" || failed "results are not overwritten"
sphonic run case.json --out kept --force --set /until=0.001
[[ $code == 0 && $(cd kept && cksum ./*) != "$before" ]] && ok "but replaced with --force" || failed "but replaced with --force" "$code" "$err"
misused 5 'case.json: exists already. *' run case.json --out case.json
misused 5 'case.json: holds something other than results of a run. Give another --out' run case.json --out case.json --force
misused 5 'case.json/out: cannot be created: Not a directory. Check space and permissions' run case.json --out case.json/out
misused 5 '/proc/sphonic/out: cannot be created: No such file or directory. Check space and permissions' run case.json --out /proc/sphonic/out

# in_parent OPTIONS: a run into a file system that mount makes with these options in parent; nobody else sees it.
in_parent() {
    code=0
    unshare -m bash -c 'mount -t tmpfs -o "$1" none parent && shift && { "$@"; code=$?; ls -A parent >left; exit "$code"; }' - \
        "$1" "$driver" run case.json --out parent/out >out 2>err </dev/null || code=$?
    hear
}
if unshare -m mount -t tmpfs -o size=4k none parent 2>/dev/null; then
    in_parent ro
    compare "a run into a file system without write permission" 5 exactly \
        'parent/out: cannot be created: Read-only file system. Check space and permissions'
    for size in 4 8 16 24 40 100; do    # of the text files, and of the charts
        in_parent "size=${size}k"
        compare "a run into a file system of $size kB" 5 like '*parent/.out.*.part/*'
        [[ ! -s left ]] && ok "leaves nothing behind" || failed "leaves nothing behind" "$(<left)"
    done
else
    echo "skipped a full disk: mount is not permitted"
fi
code=0
(ulimit -f 4 && exec "$driver" run case.json --out parent/out) >out 2>err </dev/null || code=$?
hear
compare "a run whose files may not grow" 5 like 'parent/.out.*.part/profile.csv: cannot be written: File too large. Check space and permissions'

if [[ $(id -u) == 0 ]]; then
    echo "skipped folders without permission: root may write anywhere"
else
    mkdir -m 555 readable && mkdir -m 000 closed
    misused 5 'readable/out: cannot be created: Permission denied. Check space and permissions' run case.json --out readable/out
    misused 5 'closed/out: cannot be created: Permission denied. Check space and permissions' run case.json --out closed/out
fi
sphonic run case.json --set /integrator/courant=3
[[ ! -e runs ]] && ok "a refused run leaves no runs folder" || failed "a refused run leaves no runs folder"
rm -rf runs

echo "--- interruptions"
sed -e 's/"until": 0.005/"until": 1e4/' case.json >long.json
printf '{ "case": "long.json", "vary": [ { "name": "end", "pointer": "/until", "values": [0.001, 1e4] } ] }' >study.json
# interrupted SIGNAL CODE PATTERN GLOB ARGUMENTS...: a job that is stopped once there is something at a path of this shape.
interrupted() {
    code=0
    set -m    # jobs of scripts ignore SIGINT otherwise
    "$driver" "${@:5}" >out 2>err </dev/null &
    set +m
    local job=$!
    for ((i = 0; i < 400; ++i)); do
        found=$(compgen -G "$4") && [[ -s $found ]] && break
        sleep 0.05
    done
    kill -"$1" "$job"
    wait "$job" || code=$?
    hear
    compare "SIG$1 in ${*:5}" "$2" like "$3"
}
for signal in INT:130 TERM:143 HUP:129; do
    interrupted "${signal%:*}" "${signal#*:}" 'long.json: interrupted at t = * s; nothing was written' 'parent/.out.*.part' run long.json --out parent/out
done
interrupted TERM 143 'study.json: interrupted in 2/2 end = 1*; the runs before it are kept in studied, and the same command goes on from there' 'studied/runs.jsonl' study study.json --out studied
(($(wc -l <studied/runs.jsonl) == 1)) && ok "and there they are" || failed "and there they are" "$(wc studied/runs.jsonl)"

echo "--- command line"
misused 2 '*frobnicate*' frobnicate
misused 2 '*--frobnicate*' check case.json --frobnicate
misused 2 '*CASE is required*' run
misused 2 '--set: "/until" has no "=". Write /pointer=value' check case.json --set /until
misused 2 '--set: "until" does not point to a member. *' check case.json --set until=1
misused 2 'describe: there is no plugin kind "colour". Known: *' describe colour blue
misused 2 'describe: there is no plugin kind "kernal". Did you mean "kernel"?' describe kernal
misused 2 'describe: there is no kernel named "cubic_splin". Did you mean "cubic_spline"?' describe kernel cubic_splin
misused 2 '*--json excludes --markdown*' describe --json --markdown
for threads in 0 -1 x 1.5 1025; do
    for command in 'run case.json' 'study study.json'; do
        # shellcheck disable=SC2086  # words
        misused 2 "--threads: Value $threads not in range 1 to 1024*" $command --threads "$threads" --out parent/out
    done
done

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

sphonic check case.json --set /sources/0/amplitude=2e4
[[ $code == 0 && $err == *'case.json: the sound is beyond linear acoustics: p/(rho0 c0^2) reaches 0.17 and the Mach number 0.17, '* ]] \
    && ok "check warns of amplitudes beyond linear acoustics, with figures" || failed "check warns of amplitudes beyond linear acoustics, with figures" "$code" "$err"

if command -v python3 >/dev/null; then
    for command in "check case.json" "run case.json --out json" "list" "describe kernel gaussian" "describe kernel" "describe"; do
        # shellcheck disable=SC2086  # words
        sphonic $command --json
        [[ $code == 0 ]] && python3 -c 'import json, sys; json.load(sys.stdin)' <out 2>parse \
            && ok "$command --json is JSON" || failed "$command --json is JSON" "exit code: $code" "$(tail -n 1 parse)"
    done
else
    echo "skipped --json: there is no python3"
fi

sphonic describe --markdown
rows=$(grep -c '^|' out) cells=$(sed 's/\\|//g' out | grep -c '^|[^|]*|[^|]*|[^|]*|[^|]*|[^|]*|$')
[[ $code == 0 && -z $err && $rows -gt 50 && $rows == "$cells" ]] \
    && ok "describe --markdown gives tables whose rows have five cells" \
    || failed "describe --markdown gives tables whose rows have five cells" "exit code: $code" "$rows rows, $cells of five cells" "$err"
for plugin in $("$driver" list | sed -n 's/^  \([a-z0-9_]*\) .*/\1/p'); do
    grep -qx "### ${plugin//_/\\\\_}" out || failed "describe --markdown has $plugin"
done
sphonic run case.json --out parent/known --set '/$schema=../schema.json' --set /dimension=1.0 --set /output/every=1e300
[[ $code == 0 && $(<parent/known/resolved.json) != *schema* && $(wc -l <parent/known/probes.csv) == 3 ]] \
    && ok "an editor's \$schema means nothing, 1.0 is an integer, and samples further apart than the run are two" \
    || failed "an editor's \$schema means nothing, 1.0 is an integer, and samples further apart than the run are two" "$code" "$err"

cat >sheet.json <<'CASE'
{
  "dimension": 2, "medium": { "c0": 340, "rho0": 1 }, "equations": "linear_acoustics", "viscosity": { "type": "monaghan", "alpha": 0.1 },
  "particles": { "type": "lattice", "dx": 0.01, "lower": [0, 0], "upper": [1.4, 1.4], "jitter": 0.1 },
  "kernel": { "type": "cubic_spline", "h_over_dx": 1.2 }, "integrator": { "type": "symplectic_euler", "courant": 0.3 }, "until": 2e-4,
  "sources": [ { "type": "plane_wave", "region": "x < 0.2", "amplitude": 50, "omega": 5000, "direction": [1, 0] } ]
}
CASE
for how in '/particles/jitter=0' '/particles/motion=frozen' '/particles/motion=lagrangian'; do
    for threads in 1 2; do
        sphonic run sheet.json --threads $threads --set "$how" --out sheet$threads --force
        grep -q "\"threads\": $threads," sheet$threads/summary.json || failed "a run takes the threads that it is given" "$threads" "$err"
    done
    cmp sheet1/profile.csv sheet2/profile.csv && ok "one thread and two give the same bits with $how" || failed "one thread and two give the same bits with $how" "$err"
done

sphonic run "$repository/cases/li2015/propagation.json" --set /until=0.005 --out first
sphonic run first/resolved.json --out second
cmp -s first/profile.csv second/profile.csv && cmp -s first/resolved.json second/resolved.json \
    && ok "resolved.json runs again to the same bits" || failed "resolved.json runs again to the same bits" "exit code: $code" "$err"


echo "--- stability"
rm -rf parent/known
misused 2 'case.json: /kernel/typ: unknown key "typ". Did you mean "type"?' stability case.json --set /kernel/typ=gaussian
misused 2 '--vary /kernel/h: is not /pointer=a:b:n. Write such as --vary /kernel/h_over_dx=1:3:9' stability case.json --out parent/out --vary /kernel/h
misused 2 '--vary /kernel/h=0.04:0.08: is not /pointer=a:b:n. *' stability case.json --out parent/out --vary /kernel/h=0.04:0.08
misused 2 '--vary /kernel/h=0.04:0.08:3x: is not /pointer=a:b:n. *' stability case.json --out parent/out --vary /kernel/h=0.04:0.08:3x
misused 2 '--vary /kernel/h=0.08:0.04:3: the first value is not below the last. *' stability case.json --out parent/out --vary /kernel/h=0.08:0.04:3
misused 2 '--vary /kernel/h=0.04:0.08:1: 1 values. Ask for 2 to 400' stability case.json --out parent/out --vary /kernel/h=0.04:0.08:1
misused 2 '--vary /kernel/hh=1: case.json: /kernel/hh: unknown key "hh". Did you mean "h"?*' stability case.json --out parent/out --vary /kernel/hh=1:2:3
misused 2 '--vary /until: a map has two axes. Vary one parameter or two' stability case.json --out parent/out --vary /kernel/h=0.04:0.08:3 --vary /integrator/courant=1:2:3 --vary /until=1:2:2
misused 2 '--vary /kernel/h: is given twice. Vary one parameter or two' stability case.json --out parent/out --vary /kernel/h=0.04:0.08:3 --vary /kernel/h=0.04:0.08:3
misused 2 'case.json: /integrator: the step is a fraction of the limit, so that all is stable. Give dt or courant, or vary one of them' stability case.json --out parent/out --set '/integrator={"type":"leapfrog"}' --vary /kernel/h=0.04:0.08:3 --vary /particles/dx=0.02:0.04:2
misused 2 '*case.json: /method/type: "fdtd" tells its limit but not how it grows. Leave --long out' stability case.json --out parent/out --set '/method={"type":"fdtd"}' --long 100
misused 2 '*case.json: /method/type: "fdtd" does not show its operator. Leave --spectrum out' stability case.json --out parent/out --set '/method={"type":"fdtd"}' --spectrum
misused 2 '--precision: *' stability case.json --precision 0
misused 5 'precious: exists already. Give --force to replace it, or another --out' stability case.json --out precious
sphonic stability case.json --json
[[ $code == 0 && -z $err && $out == *'"predicted": {'*'"dt": '*'"courant_dx": '*'"measured": {'*'"dt": '*'"courant_dx": '* ]] && ok "stability prints JSON" || failed "stability prints JSON" "$code" "$err" "$out"
sphonic stability case.json --out mapped --vary /kernel/h=0.04:0.06:2 --vary /integrator/courant=1:3:2 --spectrum --steps 300
[[ $code == 0 && $(ls mapped | tr '\n' ' ') == 'map.png map.svg resolved.json spectrum.png spectrum.svg stability.json table.csv ' && $(wc -l <mapped/table.csv) == 5 ]] &&
    ok "stability writes a map and a spectrum" || failed "stability writes a map and a spectrum" "$code" "$err" "$(ls mapped)"

echo "--- kernel"
misused 2 'kernel: there is no kernel named "cubic_splin". Did you mean "cubic_spline"?' kernel cubic_splin
misused 2 'kernel: there is no kernel named "wendland". *' kernel cubic_spline --compare wendland
misused 5 'precious: exists already. Give --force to replace it, or another --out' kernel cubic_spline --out precious
sphonic kernel super_gaussian --compare cubic_spline --dimension 1 --out card
[[ $code == 0 && $(ls card | tr '\n' ' ') == 'comparison.png comparison.svg cubic_spline.html cubic_spline.png cubic_spline.svg summary.json super_gaussian.html super_gaussian.png super_gaussian.svg ' ]] &&
    grep -q '<svg' card/super_gaussian.html && ! grep -qE '(src|href)="?http' card/super_gaussian.html &&
    ok "kernel writes pages and charts" || failed "kernel writes pages and charts" "$code" "$err" "$(ls card)"
sphonic kernel cubic_spline --json
[[ $code == 0 && -z $err && $out == *'"name": "cubic_spline"'*'"dimensions": '*'"rows": '*'"cutoff_ppw": '*'"courant_dx": '*'"leapfrog": '*'"speed_error": '* || $out == *'"courant_dx": '*'"rk4": '* ]] &&
    ok "kernel prints JSON" || failed "kernel prints JSON" "$code" "$err" "$out"
