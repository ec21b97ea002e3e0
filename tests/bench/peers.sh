#!/usr/bin/env bash
# Runs slicefarm and PrusaSlicer in turn on the same models with the same config.ini, and prints the cost of each.
#
#   tests/bench/peers.sh MODEL...        `model key slicefarm peer ratio` rows
#
# keys  wall_s cpu_s rss_mb (medians of RUNS runs, whole process)  path_mm travel_mm (of the G-code).
# RUNS    number of runs of each, in turn (default 3).
# CONFIG  the config.ini (default tests/corpus/config/peers.ini).
# SLICEFARM_BIN  folder of slicefarm (default build/bin).
# PrusaSlicer is Debian's package prusa-slicer; only this benchmark needs it.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
config=$(realpath "${CONFIG:-$root/tests/corpus/config/peers.ini}")
bin=$(realpath "${SLICEFARM_BIN:-$root/build/bin}")
[[ $# -gt 0 ]] || { sed -n '2,11s/^# \{0,1\}//p' "$0"; exit 2; }
command -v prusa-slicer >/dev/null || { echo "peers.sh: install the package prusa-slicer" >&2; exit 1; }
exec python3 "$here/peers.py" --runs "${RUNS:-3}" --config "$config" --slicefarm "$bin/slicefarm" "$@"
