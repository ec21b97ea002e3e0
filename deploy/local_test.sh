#!/usr/bin/env bash
# `deploy/local.sh down` leaves a process alone that only has the number of one of ours, and ends one that is ours.
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
# Reaps it, so that `down` sees it go.
SLICEFARM_STATE=$state deploy/local.sh down >"$state/out" &
wait "$ours" || true
wait $!
kill -0 "$stranger" || { echo "down ended a stranger" >&2; exit 1; }
! kill -0 "$ours" 2>/dev/null || { echo "down left ours alone" >&2; exit 1; }
