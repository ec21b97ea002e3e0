#!/bin/bash
# Measures the cost of copies of a model: CPU seconds, user and system, for one copy and for a plate of N. PrusaSlicer runs the
# same plate in turn, with the settings of tests/corpus/config/peers.ini. Each value is the least of ROUNDS runs.
#   tests/bench/copies.sh MODEL N [ROUNDS]
# Prints `key value` rows: cpu_one cpu_n ratio stages_one stages_n stages_ratio prusa_cpu_n prusa_ratio.
#   ratio        cpu_n divided by N times cpu_one
#   stages       slicing, planning, beading and infill by the reports' times on one thread; longer than CPU time on a busy machine
#   prusa_ratio  cpu_n divided by prusa_cpu_n
# Without prusa-slicer its rows are missing.
set -euo pipefail
cd "$(dirname "$0")/../.."
model=$1 count=$2 rounds=${3:-3}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
bed=0x0,2000x0,2000x2000,0x2000

seconds() {  # CPU seconds of a command
  local TIMEFORMAT='%U %S'
  { time "$@" >"$out/said" 2>&1 || { cat "$out/said" >&2; exit 1; }; } 2>&1 | awk '{ print $1 + $2 }'
}
ours() {  # CPU seconds of slicefarm for a number of copies
  seconds build/bin/slicefarm slice "$model" -q -o "$out/$1.gcode" --threads 1 --copies "$model=$1" \
    --config tests/corpus/config/peers.ini --set bed_shape=$bed --report "$out/report.json"
}
stages() {  # stage times of the last run
  python3 -c 'import json, sys
times = json.load(open(sys.argv[1]))["stage_times_s"]
print(sum(times[stage] for stage in ("slicing", "planning", "beading", "infill")))' "$out/report.json"
}
theirs() {
  seconds prusa-slicer --export-gcode --load tests/corpus/config/peers.ini --bed-shape $bed --duplicate "$count" \
    -o "$out/theirs.gcode" "$model"
}
least() { sort -n "$out/$1" | head -1; }

for ((i = 0; i < rounds; ++i)); do
  ours 1 >>"$out/one"
  stages >>"$out/stages_one"
  ours "$count" >>"$out/many"
  stages >>"$out/stages_many"
  if command -v prusa-slicer >/dev/null; then theirs >>"$out/theirs"; fi
done
awk -v one="$(least one)" -v many="$(least many)" -v n="$count" \
  'BEGIN { printf "cpu_one %.2f\ncpu_n %.2f\nratio %.3f\n", one, many, many / (n * one) }'
awk -v one="$(least stages_one)" -v many="$(least stages_many)" \
  'BEGIN { printf "stages_one %.3f\nstages_n %.3f\nstages_ratio %.3f\n", one, many, many / one }'
if [ -f "$out/theirs" ]; then
  awk -v many="$(least many)" -v theirs="$(least theirs)" \
    'BEGIN { printf "prusa_cpu_n %.2f\nprusa_ratio %.3f\n", theirs, many / theirs }'
fi
