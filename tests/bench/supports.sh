#!/bin/bash
# Measures the cost of supports: plastic, CPU, layers.
#   tests/bench/supports.sh MODEL.stl... [--peer]
# Rows: `model style support_mm3 cpu_s layers`, for the styles grid, snug and organic. cpu_s is the CPU time that supports
# add to a run with one thread: the least of three runs with supports, less the least of three runs without. With --peer,
# PrusaSlicer's values follow; a style that the installed version does not have has `-` (2.5 has no organic one).
set -euo pipefail
cd "$(dirname "$0")/../.."
peer=
models=()
for word in "$@"; do
  case $word in
    --peer) peer=1 ;;
    --*) echo "supports.sh: what is $word?" >&2; exit 2 ;;
    *) models+=("$word") ;;
  esac
done
[[ ${#models[@]} -gt 0 ]] || { echo "usage: supports.sh MODEL.stl... [--peer]" >&2; exit 2; }
[[ -z $peer ]] || command -v prusa-slicer >/dev/null || { echo "supports.sh: no prusa-slicer" >&2; exit 2; }
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

# Prints the least CPU time of three runs in seconds, or `-` if a run fails.
least() {
  local best=999999 now
  for _ in 1 2 3; do
    /usr/bin/time -f '%U %S' -o "$out/time" "$@" >"$out/said" 2>&1 || { echo -; return; }
    now=$(awk '{print $1 + $2}' "$out/time")
    best=$(awk -v a="$now" -v b="$best" 'BEGIN {print a < b ? a : b}')
  done
  echo "$best"
}
# Prints the columns from the time with supports, the time without, and the file.
row() {
  [[ $1 != - && $2 != - ]] || { echo '- - -'; return; }
  read -r volume layers <<<"$(python3 tests/bench/supports.py "$3")"
  awk -v v="$volume" -v a="$1" -v b="$2" -v l="$layers" 'BEGIN {printf "%s %.2f %s\n", v, a - b, l}'
}
ours() { least build/bin/slicefarm slice "$1" -o "$out/ours.gcode" --config tests/corpus/config/peers.ini --threads 1 "${@:2}"; }
theirs() {
  rm -f "$out/peer.gcode"
  local cpu
  cpu=$(least taskset -c 0 prusa-slicer --load tests/corpus/config/peers.ini --export-gcode -o "$out/peer.gcode" "${@:2}" "$1")
  [[ -s $out/peer.gcode ]] && echo "$cpu" || echo -
}

echo "model style support_mm3 cpu_s layers${peer:+ | PrusaSlicer: support_mm3 cpu_s layers}"
for model in "${models[@]}"; do
  without=$(ours "$model")
  [[ -z $peer ]] || peer_without=$(theirs "$model")
  for style in grid snug organic; do
    with=$(ours "$model" --set support_material=1 --set support_material_style=$style)
    columns="$(basename "${model%.*}") $style $(row "$with" "$without" "$out/ours.gcode")"
    if [[ -n $peer ]]; then
      with=$(theirs "$model" --support-material --support-material-style $style)
      columns="$columns | $(row "$with" "$peer_without" "$out/peer.gcode")"
    fi
    echo "$columns"
  done
done
