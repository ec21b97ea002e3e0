#!/usr/bin/env bash
# Moves the blobs of a farm into a bucket: models, results and traces. Jobs stay in the database.
#
#   deploy/move-blobs.sh FROM TO
#
# FROM: the state directory of a coordinator that is stopped; or the connection string of a PostgreSQL database. In the second
#       case all coordinators must have been started with --s3 TO before. They keep running and read old blobs from the database.
# TO:   http[s]://HOST[:PORT]/BUCKET[/PREFIX]; AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY are in the environment.
#       More flags, such as --s3-region, may follow.
#
# It may be interrupted at any time and run again. A blob is deleted from FROM only after the bucket has acknowledged all of
# its bytes, by their SHA-256. Incomplete uploads are not moved. SLICEFARM_BIN: folder of the programs (default build/bin, if
# it exists).
set -euo pipefail

usage() { sed -n '2,15s/^# \{0,1\}//p' "$0"; exit 2; }
[[ $# -ge 2 && $2 == http*://* ]] || usage
from=$1 to=$2
shift 2

here=$(cd "$(dirname "$0")/.." && pwd)
bin=${SLICEFARM_BIN:-$here/build/bin}
program=slicefarm-coordinator
[[ -x $bin/$program ]] && program=$bin/$program

if [[ -d $from ]]; then
  [[ -f $from/jobs.db ]] || { echo "move-blobs: $from is no state directory: it has no jobs.db" >&2; exit 1; }
  exec "$program" move-blobs --state-dir "$from" --s3 "$to" "$@"
fi
exec "$program" move-blobs --postgres "$from" --s3 "$to" "$@"
