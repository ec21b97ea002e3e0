#!/usr/bin/env bash
# Runs every service as a process of its own on this machine, without containers.
#
#   deploy/local.sh up [--workers N] [--mode fused|split] [--port P] [--store sqlite|postgres] [--coordinators N]
#                      [--metrics-port M] [--tls] [--proxy]
#   deploy/local.sh status
#   deploy/local.sh down.
#
# up       starts the services and waits until the coordinator answers on 127.0.0.1:P (default 50050). Further services use
#          the ports above it. fused: N workers with the four layer stages in each. split: N replicas of each layer stage.
#          sqlite: jobs and blobs in a directory. postgres: in a database, which N active coordinators share. The database is
#          SLICEFARM_POSTGRES (a connection string), or on a server that is started here.
#          --metrics-port: coordinators serve /metrics and /statusz on 127.0.0.1:M and the ports above it.
#          --tls: uses certificates of deploy/dev-certs.sh, in $SLICEFARM_STATE/certs, and prints the options for clients.
#          --proxy: 127.0.0.1:P is the farm's door (deploy/proxy), with the coordinators behind it; for more than a trial.
#          A service that was ended by a signal, or that accepts no connections any more (exit code 3), is started again.
# down     ends all services (SIGTERM) and waits for them. Unfinished jobs continue at the next `up`.
#
# SLICEFARM_BIN     folder of the programs (default build/bin)
# SLICEFARM_STATE   folder of jobs, blobs, logs and process ids (default build/local)
set -euo pipefail
cd "$(dirname "$0")/.."

bin=${SLICEFARM_BIN:-build/bin}
state=${SLICEFARM_STATE:-build/local}

usage() { sed -n '2,21s/^# \{0,1\}//p' "$0"; exit 2; }
die() { echo "local.sh: $*" >&2; exit 1; }

# Succeeds if the process of a pid file is the program that was started under its name. After a reboot, or when process ids are
# reused, it may be another program.
running() {
  [[ -f "$1" ]] || return 1
  local name exe
  name=$(basename "$1" .pid)
  if [[ "$name" == proxy ]]; then # a script; its executable is the shell
    tr '\0' '\n' <"/proc/$(cat "$1")/cmdline" 2>/dev/null | grep -qx 'deploy/proxy/proxy.sh'
    return
  fi
  exe=$(readlink "/proc/$(cat "$1")/exe") || return 1
  exe=${exe% (deleted)}  # the program was rebuilt while it ran
  [[ "${exe##*/}" == "slicefarm-${name%%-[0-9]*}" ]]
}

# start NAME PROGRAM ARG...: starts a program in the background.
start() {
  rm -f "$state/pid/$1.pid"
  supervise "$@" >"$state/log/$1.log" 2>&1 </dev/null &
  until [[ -s "$state/pid/$1.pid" ]]; do sleep 0.01; done
}

# supervise NAME PROGRAM ARG...: starts the program again each time it ends by itself, until `down` removes its pid file.
supervise() {
  local name=$1 file=$state/pid/$1.pid pid rc
  shift
  while :; do
    "$@" &
    pid=$!
    echo "$pid" >"$file"
    rc=0
    wait "$pid" || rc=$?
    [[ $rc -gt 128 || $rc -eq 3 ]] || return 0
    sleep 1
    [[ "$(cat "$file" 2>/dev/null)" == "$pid" ]] || return 0
  done
}

await() {
  local name=$1 address=$2
  for _ in $(seq 100); do
    "$bin/slicefarm" health "$address" >/dev/null 2>&1 && return
    kill -0 "$(cat "$state/pid/$name.pid")" 2>/dev/null || { tail -n 5 "$state/log/$name.log" >&2; die "$name did not start; its log is $state/log/$name.log"; }
    sleep 0.1
  done
  die "$name does not answer on $address; its log is $state/log/$name.log"
}

up() {
  local workers=2 mode=fused port=50050 store=sqlite coordinators=1 metrics_port='' tls=0 proxy=0
  while [[ $# -gt 0 ]]; do
    case "$1" in
      --workers) workers=${2:?}; shift 2 ;;
      --mode) mode=${2:?}; shift 2 ;;
      --port) port=${2:?}; shift 2 ;;
      --store) store=${2:?}; shift 2 ;;
      --coordinators) coordinators=${2:?}; shift 2 ;;
      --metrics-port) metrics_port=${2:?}; shift 2 ;;
      --tls) tls=1; shift ;;
      --proxy) proxy=1; shift ;;
      *) usage ;;
    esac
  done
  [[ "$workers" =~ ^[1-9][0-9]*$ ]] || die "--workers $workers: a number from 1 is needed"
  [[ "$mode" == fused || "$mode" == split ]] || die "--mode $mode: fused or split"
  [[ "$store" == sqlite || "$store" == postgres ]] || die "--store $store: sqlite or postgres"
  [[ "$coordinators" =~ ^[1-9][0-9]*$ ]] || die "--coordinators $coordinators: a number from 1 is needed"
  [[ "$metrics_port" =~ ^[0-9]*$ ]] || die "--metrics-port $metrics_port: a port is needed"
  [[ "$coordinators" -eq 1 || "$store" == postgres ]] || die "--coordinators $coordinators: several share a database: --store postgres"
  [[ -x "$bin/slicefarm-coordinator" ]] || die "no programs in $bin: run deploy/setup.sh, then cmake --preset release && cmake --build --preset release"
  mkdir -p "$state/log" "$state/pid" "$state/coordinator"
  for pid in "$state"/pid/*.pid; do running "$pid" && die "already up: deploy/local.sh down stops it"; done

  # use_certs ROLE: programs started from here on use the certificate of this role.
  use_certs() {
    [[ $tls -eq 1 ]] || return 0
    local of=$state/certs/$1
    export SLICEFARM_TLS_CERT=$of/cert.pem SLICEFARM_TLS_KEY=$of/key.pem SLICEFARM_TLS_CA=$of/ca.pem
  }
  [[ $tls -eq 0 ]] || deploy/dev-certs.sh "$state/certs"

  local next=$((port + 1)) pools=()
  # replicas STAGE COUNT FLAG: starts COUNT processes of slicefarm-STAGE, and adds their addresses as the coordinator's --FLAG.
  replicas() {
    local addresses=() role=stage-$1
    [[ "$1" == worker ]] && role=worker
    use_certs "$role"
    for i in $(seq "$2"); do
      start "$1-$i" "$bin/slicefarm-$1" --listen "127.0.0.1:$next"
      await "$1-$i" "127.0.0.1:$next"
      addresses+=("127.0.0.1:$next")
      next=$((next + 1))
    done
    pools+=("--$3" "$(IFS=,; echo "${addresses[*]}")")
  }
  replicas slicing 1 slicing
  replicas planning 1 planning
  replicas exposure 1 exposure
  replicas milling 1 milling
  replicas texture 1 texture
  if [[ "$mode" == fused ]]; then
    replicas motion 1 motion
    replicas worker "$workers" workers
  else
    for stage in beading infill ordering motion; do replicas "$stage" "$workers" "$stage"; done
  fi
  if [[ "$store" == sqlite ]]; then
    unset SLICEFARM_POSTGRES # it would be a second store
    pools+=(--state-dir "$state/coordinator")
  else
    [[ -n "${SLICEFARM_POSTGRES:-}" ]] || SLICEFARM_POSTGRES=$(deploy/postgres/server.sh start "$state/postgres")
    export SLICEFARM_POSTGRES # an argument would show its password in the list of processes
  fi
  local addresses=()
  use_certs coordinator
  for i in $(seq "$coordinators"); do
    local at=$port metrics=()
    [[ -z "$metrics_port" ]] || metrics=(--metrics-port $((metrics_port + i - 1)))
    [[ $i -eq 1 && $proxy -eq 0 ]] || { at=$next; next=$((next + 1)); }
    start "coordinator-$i" "$bin/slicefarm-coordinator" --listen "127.0.0.1:$at" --name "coordinator-$i" "${metrics[@]}" "${pools[@]}"
    await "coordinator-$i" "127.0.0.1:$at"
    addresses+=("127.0.0.1:$at")
  done
  local server=${addresses[0]}
  [[ $coordinators -eq 1 ]] || server="ipv4:$(IFS=,; echo "${addresses[*]}")" # the client selects a running one
  if [[ $proxy -eq 1 ]]; then
    use_certs proxy
    server=127.0.0.1:$port
    start proxy deploy/proxy/proxy.sh --listen "$server" --coordinators "$(IFS=,; echo "${addresses[*]}")" \
      --coordinator-name localhost --dir "$(realpath "$state")/proxy"
    await proxy "$server"
  fi
  echo "up: $mode, $workers replicas; submit with --server $server"
  use_certs tenant-dev
  [[ $tls -eq 0 ]] || echo "export SLICEFARM_TLS_CERT=$SLICEFARM_TLS_CERT SLICEFARM_TLS_KEY=$SLICEFARM_TLS_KEY SLICEFARM_TLS_CA=$SLICEFARM_TLS_CA SLICEFARM_TLS_SERVER_NAME=localhost"
}

status() {
  local any=0
  for pid in "$state"/pid/*.pid; do
    [[ -f "$pid" ]] || continue
    any=1
    if running "$pid"; then echo "$(basename "$pid" .pid) running, process $(cat "$pid")"; else echo "$(basename "$pid" .pid) stopped"; fi
  done
  [[ $any -eq 1 ]] || echo "nothing is up"
}

down() {
  for pid in "$state"/pid/proxy.pid "$state"/pid/coordinator-*.pid "$state"/pid/*.pid; do running "$pid" && kill -TERM "$(cat "$pid")"; done
  for pid in "$state"/pid/*.pid; do
    [[ -f "$pid" ]] || continue
    while running "$pid"; do sleep 0.1; done
    rm -f "$pid"
  done
  [[ ! -d "$state/postgres" ]] || deploy/postgres/server.sh stop "$state/postgres"
  echo "down"
}

command=${1:-}; [[ $# -gt 0 ]] && shift
case "$command" in
  up) up "$@" ;;
  status) status ;;
  down) down ;;
  *) usage ;;
esac
