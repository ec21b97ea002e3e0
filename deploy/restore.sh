#!/usr/bin/env bash
# Brings back what deploy/backup.sh copied, into a new place. Start the coordinators afterwards: jobs that had not ended
# go on.
#
#   deploy/restore.sh sqlite BACKUP STATE_DIR    for --state-dir STATE_DIR, which must not hold a state yet; run by root, what
#                                                is brought back belongs to the owner of STATE_DIR
#   deploy/restore.sh postgres BACKUP            into the empty database that SLICEFARM_POSTGRES (a connection string) says
#
# Every blob's bytes are compared with its name, which is their SHA-256; one that has changed is named, and is not brought
# back. Ends with an error if there were any.
# Needs the packages sqlite3, or postgresql-client-15.
set -euo pipefail
umask 077

usage() { sed -n '2,12s/^# \{0,1\}//p' "$0"; exit 2; }
die() { echo "restore: $*" >&2; exit 1; }

# Nothing is swept until a restored database has been in use for a day: it may be the wrong one.
forget_use="DELETE FROM chores WHERE name IN ('use_begin', 'use_last')"

# Files in the folders of $1 whose SHA-256 is another than their name.
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
  [[ $(id -u) -ne 0 ]] || chown -R --reference="$state" "$state" # else only root could run the coordinator
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
  # PostgreSQL puts a blob together in memory for this, up to 1 GB; coordinators check the others when they read them.
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
