#!/usr/bin/env bash
# What the container of deploy/postgres/Dockerfile runs: makes the database when its volume is empty, then serves it.
# POSTGRES_PASSWORD is that of the user slicefarm, who owns it.
set -euo pipefail
if [[ ! -s $PGDATA/PG_VERSION ]]; then
  initdb --username=slicefarm --auth-local=trust --auth-host=scram-sha-256 --encoding=UTF8 --locale=C.UTF-8 \
    --pwfile=<(echo "${POSTGRES_PASSWORD:?the password is to be set}") >/dev/null
  echo "host all all all scram-sha-256" >>"$PGDATA/pg_hba.conf"
  echo "CREATE DATABASE slicefarm;" | postgres --single -D "$PGDATA" postgres >/dev/null
fi
exec postgres -c listen_addresses='*' -c unix_socket_directories=/tmp
