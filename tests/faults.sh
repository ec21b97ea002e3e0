#!/usr/bin/env bash
# Kills processes of a running farm at random, and checks that every acknowledged job ends as it would have without that:
#
#   tests/faults.sh --kills N --jobs M --store sqlite|postgres|s3 --seed S [--workers N] [--split] [--slow P]
#
# --workers: so many (2), with --split so many replicas of each layer stage. --slow: the part of the kills before which a
# worker is stopped for up to 2 s (0), so that its ranges are given to others as well.
#
# s3: jobs are in PostgreSQL, and blobs in a bucket (fake_s3.py) that is killed as well, and of whose answers every fiftieth is a fault.
#
# `key value` rows: kills, jobs, lost (acknowledged, and not there, not SUCCEEDED or without G-code), duplicated (there more than once),
# differing (G-code, as a client gets it, unlike that of `slicefarm slice`), ranges (finished, and so compared), recover_p99_s (from a kill to the
# next finished range). Exit code 1 if there is anything lost, duplicated or differing. SLICEFARM_BIN: where the programs are (default build/bin).
set -euo pipefail
exec python3 "$(dirname "$0")/faults.py" "$@"
