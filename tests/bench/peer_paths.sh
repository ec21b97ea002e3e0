#!/usr/bin/env bash
# Slices models with slicefarm and PrusaSlicer by the same config.ini. A checker of G-code then counts the moves between
# the beads of both.
#
#   TRAVEL_CHECK=PROGRAM tests/bench/peer_paths.sh MODEL...        `model key slicefarm peer ratio` rows
#
# TRAVEL_CHECK  a program that prints `key value` rows for a G-code file.
# KEYS    the selected rows (default: travel_mm retractions crossings paths paths_below_1mm).
# CONFIG  the config.ini (default tests/corpus/config/peers.ini).
# SET     further `key=value` settings for both programs, separated by spaces.
# SLICEFARM_BIN  folder of slicefarm (default build/bin).
# PrusaSlicer is Debian's package prusa-slicer; only this benchmark needs it. A model that it refuses has `-`.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
config=$(realpath "${CONFIG:-$root/tests/corpus/config/peers.ini}")
bin=$(realpath "${SLICEFARM_BIN:-$root/build/bin}")
read -ra keys <<<"${KEYS:-travel_mm retractions crossings paths paths_below_1mm}"
read -ra sets <<<"${SET:-}"
[[ $# -gt 0 && -n ${TRAVEL_CHECK:-} ]] || { sed -n '2,14s/^# \{0,1\}//p' "$0"; exit 2; }
command -v prusa-slicer >/dev/null || { echo "peer_paths.sh: install the package prusa-slicer" >&2; exit 1; }
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
ours=(); cp "$config" "$work/peer.ini"
for set in "${sets[@]}"; do
  ours+=(--set "$set")
  { grep -v "^${set%%=*} *=" "$work/peer.ini" || true; echo "$set"; } >"$work/next.ini"; mv "$work/next.ini" "$work/peer.ini"
done
for model in "$@"; do
  name=$(basename "${model%.*}")
  rm -f "$work"/*.gcode; : >"$work/peer"
  "$bin/slicefarm" slice "$model" -o "$work/ours.gcode" --config "$config" "${ours[@]}" >/dev/null 2>&1
  "$TRAVEL_CHECK" "$work/ours.gcode" >"$work/ours"
  prusa-slicer --export-gcode --load "$work/peer.ini" -o "$work/peer.gcode" "$model" >/dev/null 2>&1 || true
  if [[ -s $work/peer.gcode ]]; then "$TRAVEL_CHECK" "$work/peer.gcode" >"$work/peer"; fi
  for key in "${keys[@]}"; do
    awk -v name="$name" -v key="$key" '
      $1 == key { value[FILENAME] = $2; seen[FILENAME] = 1 }
      END { o = value[ARGV[1]] + 0; p = value[ARGV[2]] + 0
            if (!seen[ARGV[2]]) print name, key, o, "-", "-"
            else if (p > 0) printf "%s %s %s %s %.2f\n", name, key, o, p, o / p
            else print name, key, o, p, "-" }' "$work/ours" "$work/peer"
  done
done
