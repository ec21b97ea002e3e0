#!/bin/bash
# Measures each pattern of sparse infill on a box of 80 x 80 x 16 mm with one wall and no skins: one run, one table.
#   tests/bench/infill.sh [--peer] [--density 20] [PATTERN...]
# Rows: `pattern asked got paths longest_mm travels travel_mm moves cpu_s`. got: plastic of the infill divided by the room
# within the walls, %; paths, longest_mm: of infill; travels, travel_mm, moves (that print): of the file; cpu_s: user and
# system, one thread. With --peer, PrusaSlicer's columns follow, if it has the pattern and prusa-slicer is installed.
set -euo pipefail
cd "$(dirname "$0")/../.."
peer= density=20
while [[ ${1:-} == --* ]]; do
  case $1 in
    --peer) peer=1; shift ;;
    --density) density=$2; shift 2 ;;
    *) echo "infill.sh: what is $1?" >&2; exit 2 ;;
  esac
done
patterns=("$@")
if [[ ${#patterns[@]} == 0 ]]; then
  # All patterns in the order of the settings, without `auto`, which is no pattern.
  mapfile -t patterns < <(build/bin/slicefarm settings fill_pattern --json |
    python3 -c 'import json, sys
range = next(s["range"] for s in json.load(sys.stdin) if s["key"] == "fill_pattern")
print(range.removeprefix("one of ").removesuffix(", auto").replace(", ", "\n"))')
fi
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
python3 tests/bench/infill_box.py box >"$out/box.stl"
cat tests/corpus/config/peers.ini - >"$out/box.ini" <<END
perimeters = 1
top_solid_layers = 0
bottom_solid_layers = 0
fill_density = $density%
END

seconds() {  # time of a command
  local TIMEFORMAT='%U %S'
  { time "$@" >"$out/said" 2>&1 || { cat "$out/said" >&2; exit 1; }; } 2>&1 | awk '{ print $1 + $2 }'
}
row() { echo "$(python3 tests/bench/infill_box.py measure "$1") $2"; }

head="pattern asked got paths longest_mm travels travel_mm moves cpu_s"
[[ -z $peer ]] || head+=" | got paths longest_mm travels travel_mm moves cpu_s"
echo "$head"
for pattern in "${patterns[@]}"; do
  took=$(seconds build/bin/slicefarm slice "$out/box.stl" -q -o "$out/ours.gcode" --threads 1 --config "$out/box.ini" \
    --set fill_pattern="$pattern")
  line="$pattern $density $(row "$out/ours.gcode" "$took")"
  if [[ -n $peer ]] && command -v prusa-slicer >/dev/null; then
    if took=$(seconds prusa-slicer --export-gcode --load "$out/box.ini" --fill-pattern "$pattern" -o "$out/theirs.gcode" \
      "$out/box.stl" 2>/dev/null); then
      line+=" | $(row "$out/theirs.gcode" "$took")"
    fi
  fi
  echo "$line"
done
