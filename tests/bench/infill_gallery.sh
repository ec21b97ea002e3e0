#!/bin/bash
# Draws a layer of every pattern of sparse infill into services/infill/gallery/NAME.png, and prints the table of
# services/infill/README.md: density got, paths, travel and CPU time on the box of tests/bench/infill.sh.
#   tests/bench/infill_gallery.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
gallery=services/infill/gallery
mkdir -p "$gallery"
python3 tests/bench/infill_box.py box 40 8 >"$out/box.stl"
tests/bench/infill.sh >"$out/table"
echo "| pattern | | density got, % | paths | travel, mm | CPU, s |"
echo "|---|---|---|---|---|---|"
tail -n +2 "$out/table" | while read -r pattern _ got paths _ _ travel _ cpu; do
  build/bin/slicefarm slice "$out/box.stl" -q -o "$out/box.gcode" --config tests/corpus/config/peers.ini --set perimeters=1 \
    --set top_solid_layers=0 --set bottom_solid_layers=0 --set fill_pattern="$pattern" </dev/null
  build/bin/slicefarm render "$out/box.gcode" --layer 16 --size 160 -o "$gallery/$pattern.png" </dev/null
  echo "| \`$pattern\` | ![]($(basename "$gallery")/$pattern.png) | $got | $paths | $travel | $cpu |"
done
