#!/usr/bin/env bash
# Runs the tests under sanitizers, and the fuzz targets for a minute each.
#
#   deploy/sanitize.sh [asan] [tsan] [fuzz]      default: all three
set -euo pipefail
cd "$(dirname "$0")/.."

(($#)) || set -- asan tsan fuzz
deploy/setup.sh
for preset in "$@"; do
  cmake --preset "$preset"
  cmake --build --preset "$preset"
  case "$preset" in
    asan) LSAN_OPTIONS="suppressions=$PWD/tests/lsan.supp:print_suppressions=0" ctest --preset asan -j "$(nproc)" -LE slow ;;
    tsan) TSAN_OPTIONS="suppressions=$PWD/tests/tsan.supp" ctest --preset tsan -j "$(nproc)" -LE slow ;;
    fuzz)
      for target in build-fuzz/bin/fuzz_*; do
        name=$(basename "$target")
        mkdir -p "build-fuzz/corpus/$name"
        "$target" -max_total_time="${FUZZ_SECONDS:-60}" -rss_limit_mb=4096 \
          "build-fuzz/corpus/$name" "tests/corpus/fuzz/${name#fuzz_}"
      done ;;
    *) echo "sanitize.sh: no preset $preset; asan, tsan or fuzz" >&2; exit 2 ;;
  esac
done
