#!/usr/bin/env bash
# guard.sh [--runs N] [--limit RATIO] [MODEL...]
# Compares the CPU time of this tree with that of the commit named in tests/bench/baseline, by stage.
# Builds `slicefarm` of that commit once (build/guard/<commit>, preset cold). Then slices each model with both programs
# alternately, with one thread, N times (4), and compares the least times. Prints a row for each model and one for the
# sum. Exits with 1 if the sum takes more than RATIO (1.05) times the baseline's.
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd)
runs=4 limit=1.05 models=()
while [ $# -gt 0 ]; do
  case $1 in
    --runs) runs=$2; shift 2 ;;
    --limit) limit=$2; shift 2 ;;
    -h|--help) sed -n '2,6s/^# //p' "$0"; exit 0 ;;
    *) models+=("$1"); shift ;;
  esac
done
if [ ${#models[@]} -eq 0 ]; then
  for name in benchy busted cable_cover featuretype mini_x_carriage printhead_rear spot thin_walls; do
    models+=("$here/tests/corpus/models/$name.stl")
  done
fi
commit=$(git -C "$here" rev-parse --verify "$(cat "$here/tests/bench/baseline")^{commit}")
tree=$here/build/guard/$commit
if [ ! -x "$tree/build/bin/slicefarm" ]; then
  echo "building the baseline, ${commit:0:8}" >&2
  git -C "$here" worktree prune
  [ -d "$tree" ] || git -C "$here" worktree add --detach "$tree" "$commit" >/dev/null
  (cd "$tree" && cmake --preset cold >/dev/null && cmake --build build --target slicefarm)
fi
cmake --build "$here/build" --target slicefarm >/dev/null
exec python3 "$here/tests/bench/pairs.py" "$tree/build/bin/slicefarm" "$here/build/bin/slicefarm" \
  --runs "$runs" --limit "$limit" "${models[@]}"
