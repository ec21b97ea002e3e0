#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test.
#
#   deploy/test.sh          the tests that CI runs
#   deploy/test.sh --slow   the slow ones too (soaks, large corpora)
set -euo pipefail
cd "$(dirname "$0")/.."

deploy/setup.sh
python3 tests/check_layers.py
python3 tests/check_docs.py
cmake --preset release
cmake --build --preset release
slow=(-LE slow)
[[ "${1:-}" == --slow ]] && slow=()
ctest --preset release -j "$(nproc)" "${slow[@]}"
