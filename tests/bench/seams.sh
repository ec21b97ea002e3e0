#!/bin/bash
# Measures the seams of parts made for this test and of any other models: one run, one table.
#   tests/bench/seams.sh [--peer] [--position aligned] [MODEL.stl...]
# Rows: `part loops jumps% step_mean step_p95 on_corner% overhanging% avoidable%`, explained in seams.py. With --peer,
# PrusaSlicer's columns follow, with the same settings, if prusa-slicer is installed.
set -euo pipefail
cd "$(dirname "$0")/../.."
peer= position=aligned
while [[ ${1:-} == --* ]]; do
  case $1 in
    --peer) peer=1; shift ;;
    --position) position=$2; shift 2 ;;
    *) echo "seams.sh: what is $1?" >&2; exit 2 ;;
  esac
done
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
models=()
for part in cylinder twisted_cube box rounded_box ell leaning sphere ellipsoid bumpy_ball vase head screw; do
  python3 tests/bench/seams.py part "$part" >"$out/$part.stl"
  models+=("$out/$part.stl")
done
grep -v '^seam_position' tests/corpus/config/peers.ini >"$out/seams.ini"
echo "seam_position = $position" >>"$out/seams.ini"

head='loops jumps% step_mean step_p95 on_corner% overhanging% avoidable%'
[[ -z $peer ]] || ! command -v prusa-slicer >/dev/null || head="$head | of PrusaSlicer: $head"
echo "part $head"
for model in "${models[@]}" "$@"; do
  build/bin/slicefarm slice "$model" -o "$out/ours.gcode" --config "$out/seams.ini" >"$out/said" 2>&1 ||
    { cat "$out/said" >&2; exit 1; }
  row="$(basename "${model%.*}") $(python3 tests/bench/seams.py measure "$out/ours.gcode")"
  if [[ -n $peer ]] && command -v prusa-slicer >/dev/null; then
    prusa-slicer --load "$out/seams.ini" --export-gcode -o "$out/peer.gcode" "$model" >"$out/said" 2>&1 ||
      { cat "$out/said" >&2; exit 1; }
    row="$row | $(python3 tests/bench/seams.py measure "$out/peer.gcode")"
  fi
  echo "$row"
done
