#!/usr/bin/env bash
# Runs a separate PostgreSQL server in a directory, for one machine and for tests. It can be reached only over a socket there.
# A farm has its own server; slicefarm needs an empty database on it and the right to create tables.
#
#   deploy/postgres/server.sh start DIR [SETTING=VALUE...]    starts it, creates it first if needed; prints a connection string
#   deploy/postgres/server.sh stop DIR                        stops it, if it runs; committed data stays
#   deploy/postgres/server.sh kill DIR                        stops it with SIGKILL to all of its processes
#   deploy/postgres/server.sh pause DIR, resume DIR           stops all of its processes, and continues them
set -euo pipefail

usage() { sed -n '2,9s/^# \{0,1\}//p' "$0"; exit 2; }
[[ $# -ge 2 ]] || usage
command=$1
mkdir -p "$2"
dir=$(cd "$2" && pwd)
shift 2
bin=$(find /usr/lib/postgresql -maxdepth 2 -name bin 2>/dev/null | sort -V | tail -1)
[[ -n $bin ]] || { echo "server.sh: the package postgresql is not installed; deploy/setup.sh does it" >&2; exit 1; }
cd / # the server's user may not be able to enter the current directory
as=()
if [[ $(id -u) -eq 0 ]]; then # PostgreSQL refuses to run as root
  chown postgres "$dir"
  as=(setpriv --reuid=postgres --regid=postgres --clear-groups)
fi

start() {
  if [[ ! -s $dir/data/PG_VERSION ]]; then
    "${as[@]}" "$bin/initdb" -D "$dir/data" -U slicefarm -A trust -E UTF8 --locale=C >"$dir/initdb.log" 2>&1 ||
      { cat "$dir/initdb.log" >&2; exit 1; }
  fi
  local options="-c listen_addresses='' -c unix_socket_directories='$dir'"
  for setting in "$@"; do options+=" -c $setting"; done
  # After a kill the first attempts may fail, because old processes still use its shared memory.
  for try in 1 2 3 4 5 6 7 8 9 10; do
    "${as[@]}" "$bin/pg_ctl" -D "$dir/data" -l "$dir/log" -o "$options" -w -s start >/dev/null 2>&1 && break
    [[ $try -lt 10 ]] || { tail -20 "$dir/log" >&2; exit 1; }
    sleep 0.5
  done
  "$bin/createdb" -h "$dir" -U slicefarm slicefarm 2>/dev/null || true # it may exist already
  echo "host=$dir user=slicefarm dbname=slicefarm"
}

processes() {
  local leader
  leader=$(head -1 "$dir/data/postmaster.pid" 2>/dev/null) || return 0
  echo "$leader $(pgrep -P "$leader" | tr '\n' ' ')"
}

signal() {
  local all
  read -ra all < <(processes) && kill -"$1" "${all[@]}" 2>/dev/null # some processes may have ended already
}

case $command in
  start) start "$@" ;;
  stop)
    signal CONT || true
    "${as[@]}" "$bin/pg_ctl" -D "$dir/data" -m fast -w -s stop >/dev/null 2>&1 || true
    ;;
  kill) signal KILL ;;
  pause) signal STOP && signal STOP ;; # the second signal stops processes that were started meanwhile
  resume) signal CONT ;;
  *) usage ;;
esac
