#!/usr/bin/env bash
# Studies that are killed, changed, spread over processes and collected: the table is that of a study left in peace.
#
#   study.sh DRIVER REPOSITORY
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

sed -e 's/"dx": 0.04/"dx": 0.02/; s/"h": 0.13/"h": 0.04/' "$repository/cases/li2015/propagation.json" >case.json
cat >study.json <<'JSON'
{ "case": "case.json", "measure": ["errors.eps", "errors.max"], "repeat": 3, "cutoff": 30, "vary": [
  { "name": "alpha", "pointer": "/viscosity/alpha", "values": [0, 0.03, 0.06], "family": true },
  { "name": "step", "values": [ { "label": "short", "set": { "/integrator": { "type": "symplectic_euler", "courant": 0.2 }, "/until": 0.004 } },
                                { "label": "large", "set": { "/integrator": { "type": "symplectic_euler", "courant": 50 } } },
                                { "label": "it's", "set": { "/integrator": { "type": "symplectic_euler", "courant": 0.5 }, "/until": 0.004 } } ] } ] }
JSON

# What the table says but for times.
told() { awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ /^(cpu_|wall_s|setup_s|ns_|timing_doubt|predicted_cpu_s)/) drop[i] = 1 }
    { line = ""; for (i = 1; i <= NF; ++i) if (!(i in drop)) line = line "," $i; print line }' "$1/table.csv"; }
same_table() { [[ $(told "$2") == "$(told peace)" ]] && ok "$1" || failed "$1" "$(diff <(told "$2") <(told peace) | head)"; }

"$driver" study study.json --out peace >peace.md 2>/dev/null || failed "a study left in peace" "$(<peace.md)"
(($(grep -c refused peace/table.csv) == 3)) && ok "three points of nine are refused" || failed "three refused points" "$(<peace/table.csv)"
[[ $(head -n 1 peace/table.csv) == *errors.max* && $(<peace.md) == *' eps '*' max '* ]] && ok "both norms are in the table" || failed "both norms" "$(<peace.md)"

echo "--- SIGKILL"
for seed in 1 2 3; do
    RANDOM=$seed kills=0
    until [[ -f killed$seed/points.jsonl ]]; do
        "$driver" study study.json --out killed$seed >/dev/null 2>&1 </dev/null &
        job=$!
        sleep "0.$((RANDOM % 700 + 300))"
        kill -KILL "$job" 2>/dev/null && kills=$((kills + 1))
        wait "$job" 2>/dev/null || true
        ((kills < 200)) || break
    done
    ((kills > 0)) && same_table "killed $kills times and gone on, the table is the same" killed$seed
done
before=$(wc -l <killed1/runs.jsonl)
"$driver" study study.json --out killed1 >/dev/null 2>err
[[ $(wc -l <killed1/runs.jsonl) == "$before" && $(<err) == *'has all runs of this study already'* ]] && ok "what is finished is not run again" || failed "what is finished" "$(<err)"

echo "--- without --out"
"$driver" study study.json >/dev/null 2>&1 </dev/null &
job=$!
for ((i = 0; i < 400; ++i)); do [[ -s runs/study/runs.jsonl ]] && break || sleep 0.02; done
kill -KILL "$job" && wait "$job" 2>/dev/null || true
"$driver" study study.json >/dev/null 2>err
[[ -f runs/study/points.jsonl && ! -e runs/study-2 ]] && ok "the same command goes on" || failed "the same command" "$(ls runs)"
same_table "to the same table" runs/study

echo "--- another study"
sed -e 's/0.06\]/0.05]/' study.json >other.json
code=0
"$driver" study other.json --out peace >/dev/null 2>err || code=$?
[[ $code == 5 && $(<err) == *'peace: holds another study: other.json: point 7 of 9 (alpha = 0.05: alpha = 0.05, short) is another case there. Give --force to replace it, or another --out' ]] &&
    ok "is refused" || failed "another study" "$code" "$(<err)"

echo "--- side by side"
"$driver" study study.json --out jobs --jobs 2 >/dev/null 2>err || failed "--jobs" "$(<err)"
same_table "two at a time, the table is the same" jobs
[[ $(<jobs/table.md) == *'ran side by side with others'* ]] && ok "and its times are in doubt" || failed "times in doubt" "$(<jobs/table.md)"

"$driver" study study.json --out jobs_killed --jobs 2 >/dev/null 2>&1 </dev/null &
job=$!
for ((i = 0; i < 400; ++i)); do compgen -G 'jobs_killed/runs-*.jsonl' >/dev/null && break || sleep 0.02; done
kill -KILL "$job" && wait "$job" 2>/dev/null || true
sleep 0.1
lines() { cat jobs_killed/runs-*.jsonl | wc -l; }
left=$(lines)
sleep 0.5
[[ $(lines) == "$left" ]] && ok "a killed study leaves no point running" || failed "points go on running" "$left, $(lines)"
"$driver" study study.json --out jobs_killed --jobs 2 >/dev/null 2>err || failed "going on with --jobs" "$(<err)"
same_table "and goes on to the same table" jobs_killed

"$driver" study study.json --out by_hand --launcher parallel --jobs 2 >commands
mapfile -t commands <commands
if command -v parallel >/dev/null; then
    eval "${commands[1]}" >/dev/null 2>err || failed "${commands[1]}" "$(<err)"
else
    bash by_hand/jobs.txt >/dev/null 2>&1
fi
eval "${commands[2]}" >/dev/null 2>&1
same_table "by GNU parallel, the table is the same" by_hand

"$driver" study study.json --out array --launcher slurm >commands
for ((task = 1; task <= 9; ++task)); do SLURM_ARRAY_TASK_ID=$task bash array/jobs.slurm >/dev/null 2>&1; done
grep -q '^#SBATCH --array=1-9$' array/jobs.slurm && ok "a Slurm array has a task for each point" || failed "the array" "$(<array/jobs.slurm)"
mapfile -t commands <commands
eval "${commands[2]}" >/dev/null 2>&1
same_table "by a Slurm array, the table is the same" array

echo "$failures failed"
((failures == 0))
