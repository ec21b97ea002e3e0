#!/usr/bin/env bash
# Shows all steps from set-up to G-code: set-up, build, every service as its own process, submit, fetch, stop.
#
#   deploy/demo.sh [MODEL.stl]      default: the benchy of tests/corpus
set -euo pipefail
cd "$(dirname "$0")/.."

model=${1:-tests/corpus/models/benchy.stl}
[[ -f "$model" ]] || { echo "demo.sh: no file $model" >&2; exit 2; }

deploy/setup.sh
[[ -f build/CMakeCache.txt ]] || cmake --preset cold
cmake --build --preset release --target programs

out=demo-out
name=$(basename "${model%.*}")
mkdir -p "$out"
deploy/local.sh up --workers 2 --mode split
trap 'deploy/local.sh down' EXIT
build/bin/slicefarm submit "$model" -o "$out/$name.gcode" --config deploy/demo.ini --report "$out/$name.json" --server 127.0.0.1:50050
build/bin/slicefarm render "$out/$name.gcode" --layer 20 -o "$out/$name-layer20.png"
echo
echo "G-code         $PWD/$out/$name.gcode"
echo "report         $PWD/$out/$name.json"
echo "layer picture  $PWD/$out/$name-layer20.png"
