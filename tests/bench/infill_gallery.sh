#!/bin/bash
# Draws a layer of every pattern of sparse infill into services/infill/gallery/NAME.png. Prints the table of
# docs/figures/infill.md: actual density, paths, travel, and CPU time on the box of tests/bench/infill.sh, and the average
# speed of the lines by the print's own estimate. The pictures show a box of 40 x 40 x 8 mm at a height of 3.2 mm.
#   tests/bench/infill_gallery.sh [PATTERN...]
set -euo pipefail
cd "$(dirname "$0")/../.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
gallery=services/infill/gallery
mkdir -p "$gallery"
python3 tests/bench/infill_box.py box 40 8 >"$out/box.stl"
tests/bench/infill.sh "$@" >"$out/table"
echo "| pattern | | density got, % | paths | travel, mm | mm/s | CPU, s |"
echo "|---|---|---|---|---|---|---|"
tail -n +2 "$out/table" | while read -r pattern _ got paths _ _ travel _ cpu; do
  build/bin/slicefarm slice "$out/box.stl" -q -o "$out/box.gcode" --report "$out/report.json" \
    --config tests/corpus/config/peers.ini --set perimeters=1 --set top_solid_layers=0 --set bottom_solid_layers=0 \
    --set fill_pattern="$pattern" </dev/null
  speed=$(python3 -c 'import json, sys
infill = json.load(open(sys.argv[1]))["features"]["Internal infill"]
print(round(infill["length_mm"] / infill["time_s"]))' "$out/report.json")
  build/bin/slicefarm render "$out/box.gcode" --layer 16 --size 160 -o "$gallery/$pattern.png" </dev/null
  echo "| \`$pattern\` | ![]($(basename "$gallery")/$pattern.png) | $got | $paths | $travel | $speed | $cpu |"
done
