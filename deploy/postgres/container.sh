#!/usr/bin/env bash
# Runs in the container of deploy/postgres/Dockerfile: creates the database if its volume has none, then serves it.
# POSTGRES_PASSWORD is the password of the database's owner, the user slicefarm. The container may be killed at any moment. The
# volume has a server's files if PG_VERSION exists, which is written last, and the database if slicefarm.made exists.
set -euo pipefail
single() { postgres --single -D "$PGDATA" postgres; }

chmod 700 "$PGDATA"
if [[ ! -s $PGDATA/PG_VERSION ]]; then
  find "$PGDATA" -mindepth 1 ! -name lost+found -delete # files of an initialisation that was killed
  initdb --username=slicefarm --auth-local=trust --auth-host=scram-sha-256 --encoding=UTF8 --locale=C.UTF-8 \
    --pwfile=<(echo "${POSTGRES_PASSWORD:?the password is to be set}") "$PGDATA/new" >/dev/null
  echo "host all all all scram-sha-256" >>"$PGDATA/new/pg_hba.conf"
  find "$PGDATA/new" -mindepth 1 -maxdepth 1 ! -name PG_VERSION -exec mv -t "$PGDATA" {} +
  sync -f "$PGDATA"
  mv "$PGDATA/new/PG_VERSION" "$PGDATA"
  rmdir "$PGDATA/new"
fi
if [[ ! -e $PGDATA/slicefarm.made ]]; then
  echo "SELECT datname FROM pg_database;" | single | grep -q 'datname = "slicefarm"' ||
    echo "CREATE DATABASE slicefarm;" | single >/dev/null
  touch "$PGDATA/slicefarm.made"
fi
# Each coordinator needs about 26 connections, and one for each of its --jobs.
exec postgres -c listen_addresses='*' -c max_connections="${MAX_CONNECTIONS:-300}" -c unix_socket_directories=/tmp
