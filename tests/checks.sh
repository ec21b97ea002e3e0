#!/usr/bin/env bash
# Runs every check of the repository that needs no build. Fails at the first check that finds a fault. Takes about ten seconds.
#
#   tests/checks.sh          reports faults.
#   tests/checks.sh --fix    formats the C++ files first.
set -euo pipefail
cd "$(dirname "$0")/.."

[[ "${1:-}" != --fix ]] || python3 tests/check_format.py --fix
for check in layers includes types cycles docs prose tests format; do
  python3 "tests/check_$check.py"
done
docs/make_api.py --check
