#!/usr/bin/env bash
# Runs the tests under sanitizers. The preset `debug` has the address and undefined-behaviour sanitizers, assertions and the
# fuzzers, which then run for a minute each. The preset `tsan` has the thread sanitizer.
#
#   deploy/sanitize.sh [debug] [tsan]      default: both
set -euo pipefail
cd "$(dirname "$0")/.."

(($#)) || set -- debug tsan
deploy/setup.sh
for preset in "$@"; do
  [[ "$preset" == debug || "$preset" == tsan ]] || { echo "sanitize.sh: no preset $preset; debug or tsan" >&2; exit 2; }
  cmake --preset "$preset"
  cmake --build --preset "$preset"
  ctest --preset "$preset" -j "$(nproc)" -LE slow
  [[ "$preset" == debug ]] || continue
  for target in build-debug/bin/fuzz_*; do
    name=$(basename "$target")
    mkdir -p "build-debug/corpus/$name"
    "$target" -max_total_time="${FUZZ_SECONDS:-60}" -rss_limit_mb=4096 \
      "build-debug/corpus/$name" "tests/corpus/fuzz/${name#fuzz_}"
  done
done
