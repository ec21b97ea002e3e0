#!/usr/bin/env bash
# Restores a backup of deploy/backup.sh to a new place. Start the coordinators afterwards: unfinished jobs continue.
#
#   deploy/restore.sh sqlite BACKUP STATE_DIR    for --state-dir STATE_DIR, which must not contain a state yet. If run by root,
#                                                the restored files belong to the owner of STATE_DIR.
#   deploy/restore.sh postgres BACKUP            to an empty database with the connection string SLICEFARM_POSTGRES.
#
# The bytes of every blob are compared with its name, which is their SHA-256. A damaged blob is reported and not restored.
# If there are damaged blobs, the script ends with an error.
# Needs the packages sqlite3, or postgresql-client-15.
set -euo pipefail
umask 077

usage() { sed -n '2,12s/^# \{0,1\}//p' "$0"; exit 2; }
die() { echo "restore: $*" >&2; exit 1; }

# No data is swept until a restored database has been in use for a day, because it may be the wrong backup.
forget_use="DELETE FROM chores WHERE name IN ('use_begin', 'use_last')"

# Prints the files in the blob folders of $1 with a SHA-256 that differs from their name.
damaged() {
  (cd "$1" && find . -path '*blobs/*' -type f -name '[0-9a-f]*' -exec sha256sum {} +) |
    awk '{ name = $2; sub(/.*\//, "", name); if ($1 != name) print $2 }'
}

restore_sqlite() {
  local backup=$1 state=$2 bad
  [[ -f $backup/jobs.db ]] || die "$backup is no backup: it has no jobs.db"
  [[ ! -e $state/jobs.db ]] || die "$state holds a state already"
  mkdir -p "$state/blobs"
  [[ $(sqlite3 "$backup/jobs.db" 'PRAGMA integrity_check') == ok ]] || die "$backup/jobs.db is damaged"
  cp -R "$backup/blobs/." "$state/blobs/"
  [[ ! -d $backup/tenants ]] || cp -R "$backup/tenants" "$state/"
  bad=$(damaged "$state")
  for blob in $bad; do rm "$state/$blob"; done
  cp "$backup/jobs.db" "$state/jobs.db.new"
  sqlite3 "$state/jobs.db.new" "$forget_use"
  [[ $(id -u) -ne 0 ]] || chown -R --reference="$state" "$state" # otherwise only root could run the coordinator
  sync --file-system "$state"
  mv "$state/jobs.db.new" "$state/jobs.db"
  [[ -z $bad ]] || die "damaged in the backup, and left out: $bad"
}

restore_postgres() {
  local backup=$1 tables bad
  [[ -x $backup ]] || die "$backup is no folder that $(id -un) may look into"
  [[ -f $backup/slicefarm.dump ]] || die "$backup is no backup: it has no slicefarm.dump"
  [[ -r $backup/slicefarm.dump ]] || die "$(id -un) may not read $backup/slicefarm.dump"
  [[ -n ${SLICEFARM_POSTGRES:-} ]] || die "SLICEFARM_POSTGRES is to say which database"
  tables=$(sql "SELECT count(*) FROM pg_tables WHERE schemaname NOT IN ('pg_catalog', 'information_schema')")
  [[ $tables == 0 ]] || die "the database is not empty"
  pg_restore --no-owner --no-privileges --exit-on-error --single-transaction --dbname="$SLICEFARM_POSTGRES" "$backup/slicefarm.dump"
  sql "$forget_use"
  # PostgreSQL assembles a blob in memory for this check, up to 1 GB. Coordinators check larger blobs when they read them.
  bad=$(sql "SELECT b.tenant || '/' || b.digest FROM blobs b WHERE b.complete = 1 AND b.size < 900000000 AND b.digest <>
    (SELECT encode(sha256(coalesce(string_agg(p.bytes, ''::bytea ORDER BY p.at), ''::bytea)), 'hex')
     FROM blob_pieces p WHERE p.tenant = b.tenant AND p.digest = b.digest)")
  for blob in $bad; do sql "DELETE FROM blobs WHERE tenant || '/' || digest = '$blob'" >/dev/null; done
  [[ -z $bad ]] || die "damaged in the backup, and left out: $bad"
}

sql() { psql --no-psqlrc --quiet --tuples-only --no-align --set=ON_ERROR_STOP=1 --dbname="$SLICEFARM_POSTGRES" --command="$1"; }

case "${1:-} $#" in
  "sqlite 3") restore_sqlite "$2" "$3" ;;
  "postgres 2") restore_postgres "$2" ;;
  *) usage ;;
esac
