#!/usr/bin/env bash
# Installs what is missing, builds everything and runs the tests.
#
#   deploy/test.sh          the tests that CI runs
#   deploy/test.sh --slow   the slow ones too (soaks, large corpora)
set -euo pipefail
cd "$(dirname "$0")/.."

deploy/setup.sh
python3 tests/check_layers.py
python3 tests/check_docs.py
[[ -f build/CMakeCache.txt ]] || cmake --preset cold
cmake --build --preset release
tests=(-LE slow)
[[ "${1:-}" == --slow ]] && tests=(-C nightly)
ctest --preset release -j "$(nproc)" "${tests[@]}"
