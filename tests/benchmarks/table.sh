#!/usr/bin/env bash
# table.sh [PROGRAM [REPETITIONS [FILTER]]]: runs bench_steps and prints its table as Markdown. Medians of CPU time over repetitions that
# are interleaved in random order, so that a busy neighbour slows all of them alike.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
program=${1:-$here/../../build/release/bin/bench_steps}
json=$(mktemp)
trap 'rm -f "$json"' EXIT
"$program" --benchmark_repetitions="${2:-9}" --benchmark_filter="${3:-.}" --benchmark_min_time=0.03 --benchmark_enable_random_interleaving=true \
           --benchmark_report_aggregates_only=true --benchmark_out="$json" --benchmark_out_format=json >/dev/null
python3 "$here/table.py" "$json" "$(git -C "$here" describe --always --dirty 2>/dev/null || echo unknown)"
