#!/usr/bin/env bash
# Tests that `deploy/local.sh down` ends the farm's own processes, and no other process with a reused id.
set -euo pipefail
cd "$(dirname "$0")/.."
state=$(mktemp -d)
trap 'kill "$stranger" "$ours" 2>/dev/null || true; rm -rf "$state"' EXIT
mkdir "$state/pid"
cp "$(command -v sleep)" "$state/slicefarm-worker"
sleep 600 & stranger=$!
"$state/slicefarm-worker" 600 & ours=$!
until [[ $(readlink "/proc/$ours/exe") == "$state/slicefarm-worker" ]]; do :; done
echo "$stranger" >"$state/pid/slicing-1.pid"
echo "$ours" >"$state/pid/worker-1.pid"
# Reaps the process, so that `down` sees its end.
SLICEFARM_STATE=$state deploy/local.sh down >"$state/out" &
wait "$ours" || true
wait $!
kill -0 "$stranger" || { echo "down ended a stranger" >&2; exit 1; }
! kill -0 "$ours" 2>/dev/null || { echo "down left ours alone" >&2; exit 1; }
