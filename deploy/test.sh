#!/usr/bin/env bash
# Installs missing packages, builds everything and runs the tests.
#
#   deploy/test.sh          the tests that CI runs.
#   deploy/test.sh --slow   the slow tests too (soaks, large corpora).
#
# If this takes less than an hour, a part of the slow tests runs too, a different one each day (tests/rotation.py).
set -euo pipefail
cd "$(dirname "$0")/.."

deploy/setup.sh
tests/checks.sh
[[ -f build/CMakeCache.txt ]] || cmake --preset cold
cmake --build --preset release
tests=(-LE slow)
[[ "${1:-}" == --slow ]] && tests=(-C nightly)

# Prints the last lines of failed tests. They name the failure and the expected result, and the whole output may be long.
tell_failures() {
  echo "What failed:" >&2
  grep -hE -A8 ': Failure$|^FAIL: |^ERROR: |^Traceback|^\[  FAILED  \]|Sanitizer:' build/Testing/Temporary/LastTest.log |
    grep -v '^{"ts"' | tail -n 80 >&2
}

if ! ctest --preset release -j "$(nproc)" "${tests[@]}"; then
  tell_failures
  # The second run repeats the failed tests, one at a time. It shows which of them fail only beside other tests. It changes no
  # verdict: a test that passes only sometimes is a fault of the test or of the program.
  echo "Once more, one at a time, what failed:" >&2
  ctest --preset release "${tests[@]}" --rerun-failed || tell_failures
  exit 1
fi
python3 tests/check_tidy.py

left=$((60 - SECONDS / 60))
if [[ $left -gt 0 ]]; then
  python3 tests/rotation.py build --minutes "$((left < 10 ? left : 10))"
else
  echo "no time is left for tests/rotation.py"
fi
