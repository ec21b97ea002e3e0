#!/usr/bin/env bash
# Kills random processes of a running farm, and checks that every acknowledged job has the same
# result as without kills:
#
#   tests/faults.sh --kills N --jobs M --store sqlite|postgres|s3 --seed S [--workers N] [--split] [--slow P]
#
# --workers: number of workers (2); with --split, number of replicas of each layer stage. --slow:
# fraction of the kills before which a worker is stopped for up to 2 s (0), so that other workers
# get its ranges as well.
#
# s3: jobs are in PostgreSQL and blobs in a bucket (fake_s3.py). The bucket is killed as well, and
# one of fifty answers is a fault.
#
# Prints `key value` rows:
# - kills, jobs;
# - lost: acknowledged jobs that are missing, not SUCCEEDED, or without G-code, and acknowledged presets that are missing;
# - duplicated: jobs that exist more than once;
# - differing: jobs with downloaded G-code that differs from the output of `slicefarm slice`;
# - ranges: finished ranges, which were thus compared;
# - recover_p99_s: time from a kill to the next finished range.
#
# The exit code is 1 if any job is lost, duplicated or differing. SLICEFARM_BIN: directory of the
# programs (default build/bin).
set -euo pipefail
exec python3 "$(dirname "$0")/faults.py" "$@"
