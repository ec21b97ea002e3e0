#!/usr/bin/env bash
# Copies the state of a farm while it works: all jobs that were acknowledged before, with their models and results.
#
#   deploy/backup.sh sqlite STATE_DIR DEST     state of a coordinator with --state-dir. DEST may contain an earlier backup;
#                                              only new blobs are copied then.
#   deploy/backup.sh postgres DEST             database with the connection string SLICEFARM_POSTGRES.
#
# A restored job never refers to a missing blob. A blob is stored before its references, and removed after them. So blobs
# are copied twice: before the database, as some may be removed later, and after it, as new ones may have arrived.
# With PostgreSQL, pg_dump copies everything as of one moment. Incomplete uploads are left out: their clients send them again.
# Needs the packages sqlite3, or postgresql-client-15. If anything fails, it ends with an error and makes no partial backup.
set -euo pipefail
umask 077

usage() { sed -n '2,13s/^# \{0,1\}//p' "$0"; exit 2; }
die() { echo "backup: $*" >&2; exit 1; }

# intact FILE: succeeds if the SHA-256 of the file is its name, apart from a dot.
intact() {
  local name
  name=$(basename "$1")
  [[ $(sha256sum <"$1") == "${name#.}  -" ]]
}

# copy_blobs FROM TO: copies the blobs that TO lacks. A blob never changes, and appears in TO only when it is complete.
copy_blobs() {
  local from=$1 to=$2 folder name
  for folder in "$from"/*/; do
    [[ -d $folder ]] || continue
    name=$(basename "$folder")
    mkdir -p "$to/$name"
    comm -23 <(ls "$folder" | sort) <(ls "$to/$name" | sort) | while read -r blob; do
      cp "$folder$blob" "$to/$name/.$blob" || { [[ ! -e $folder$blob ]] || die "cannot copy $folder$blob"; continue; }
      if intact "$to/$name/.$blob"; then mv "$to/$name/.$blob" "$to/$name/$blob"; else rm "$to/$name/.$blob"; fi
    done
  done
}

# Prints the folder of a tenant's blobs within a state directory. Without a name it is the folder of all blobs in a farm without
# tenants.
folder_of() { if [[ -z $1 ]]; then echo blobs; else echo "tenants/$1/blobs"; fi; }

# copy_all FROM TO: copies the blobs of all tenants.
copy_all() {
  local folder
  copy_blobs "$1/blobs" "$2/blobs"
  for folder in "$1"/tenants/*/blobs; do
    [[ -d $folder ]] || continue
    copy_blobs "$folder" "$2/${folder#"$1/"}"
  done
}

backup_sqlite() {
  local state=$1 dest=$2
  [[ -f $state/jobs.db ]] || die "$state is no state directory: it has no jobs.db"
  mkdir -p "$dest/blobs"
  rm -f "$dest/jobs.db.new"
  copy_all "$state" "$dest"
  sqlite3 -cmd '.timeout 60000' "$state/jobs.db" "VACUUM INTO '${dest//\'/\'\'}/jobs.db.new'"
  copy_all "$state" "$dest"
  [[ $(sqlite3 "$dest/jobs.db.new" 'PRAGMA integrity_check') == ok ]] || die "the copy of jobs.db is damaged"
  check_blobs "$dest/jobs.db.new" "$dest" "$state"
  sync --file-system "$dest"
  mv "$dest/jobs.db.new" "$dest/jobs.db"
}

# Prints TENANT|DIGEST of all blobs that jobs and results refer to.
referenced() {
  sqlite3 -separator '|' "$1" "SELECT result_tenant, gcode_sha256 FROM jobs UNION SELECT result_tenant, report_sha256 FROM jobs
    UNION SELECT tenant, trace_sha256 FROM jobs UNION SELECT tenant, gcode_sha256 FROM results
    UNION SELECT tenant, report_sha256 FROM results
    UNION SELECT jobs.tenant, digest FROM inputs JOIN jobs ON jobs.number = inputs.job" |
    { grep -E '\|[0-9a-f]{64}$' || [[ $? -eq 1 ]]; } # 1: no line matches
}

# Checks that every blob in the copied database exists, unless the farm itself has lost it.
check_blobs() {
  local database=$1 copy=$2 origin=$3 path
  referenced "$database" | while IFS='|' read -r tenant digest; do
    path=$(folder_of "$tenant")/${digest:0:2}/$digest
    [[ -f $copy/$path ]] && continue
    if [[ -f $origin/$path ]] && intact "$origin/$path"; then die "blob $digest came late: run the backup again"; fi
    echo "backup: blob $digest is lost or damaged in the store already" >&2
  done
}

backup_postgres() {
  local dest=$1
  [[ -n ${SLICEFARM_POSTGRES:-} ]] || die "SLICEFARM_POSTGRES is to say which database"
  mkdir -p "$dest"
  pg_dump --format=custom --no-owner --no-privileges --file="$dest/slicefarm.dump.new" --dbname="$SLICEFARM_POSTGRES"
  sync --file-system "$dest"
  mv "$dest/slicefarm.dump.new" "$dest/slicefarm.dump"
}

case "${1:-} $#" in
  "sqlite 3") backup_sqlite "$2" "$3" ;;
  "postgres 2") backup_postgres "$2" ;;
  *) usage ;;
esac
