#!/usr/bin/env bash
# The door of a farm: nginx in front of its coordinators (nginx.conf.in beside this file; deploy/README.md, "The door").
#
#   proxy.sh --listen HOST:PORT --coordinators HOST:PORT[,HOST:PORT...] [OPTION...]
#
# --coordinators          each name may resolve to any number of addresses; they are resolved again every 2 s.
# --coordinator-name NAME with TLS: name in the coordinators' certificates (the first host of --coordinators).
# --client-certs HOW      with TLS: required (the default), or optional, for clients that have tokens.
# --calls N               calls per second of one certificate or address, and the size of a burst after a pause (300).
# --open N                open calls of a client at the same time (2000).
# --uploads N             uploads of a client at the same time (16: a quarter of a coordinator's limit).
# --connections N         connections of each nginx worker, to clients and coordinators together (8192, or the limit of descriptors).
# --drain S               seconds that open calls get after SIGTERM, and after a renewed certificate (30).
# --dir DIR               for the configuration and the process id; created if needed (slicefarm-proxy in TMPDIR or /tmp).
#
# SLICEFARM_TLS_CERT, SLICEFARM_TLS_KEY, SLICEFARM_TLS_CA: the certificate of the role `proxy`, for clients and coordinators.
# They are read again when they change. Without them everything is in plain text.
set -euo pipefail

here=$(dirname "$(readlink -f "$0")")
listen='' coordinators='' name='' verify=on calls=300 open=2000 uploads=16 connections='' drain=30 dir=${TMPDIR:-/tmp}/slicefarm-proxy

usage() { sed -n '2,19s/^# \{0,1\}//p' "$0"; exit 2; }
die() { echo "proxy.sh: $*" >&2; exit 1; }

while [[ $# -gt 0 ]]; do
  case "$1" in
    --listen) listen=${2:?}; shift 2 ;;
    --coordinators) coordinators=${2:?}; shift 2 ;;
    --coordinator-name) name=${2:?}; shift 2 ;;
    --client-certs)
      case "${2:?}" in required) verify=on ;; optional) verify=optional ;; *) usage ;; esac
      shift 2 ;;
    --calls) calls=${2:?}; shift 2 ;;
    --open) open=${2:?}; shift 2 ;;
    --uploads) uploads=${2:?}; shift 2 ;;
    --connections) connections=${2:?}; shift 2 ;;
    --drain) drain=${2:?}; shift 2 ;;
    --dir) dir=${2:?}; shift 2 ;;
    *) usage ;;
  esac
done
[[ -n "$listen" && -n "$coordinators" ]] || usage
for number in "$calls" "$open" "$uploads" "${connections:-1}" "$drain"; do
  [[ "$number" =~ ^[1-9][0-9]*$ ]] || die "$number: a number from 1 is needed"
done
command -v nginx >/dev/null || die "there is no nginx: deploy/setup.sh installs it"
mkdir -p "$dir/tmp"

cert=${SLICEFARM_TLS_CERT:-} key=${SLICEFARM_TLS_KEY:-} ca=${SLICEFARM_TLS_CA:-}
if [[ -n "$cert" ]]; then keep=tls drop=plain scheme=grpcs; else keep=plain drop=tls scheme=grpc; fi
first=${coordinators%%,*}
[[ -n "$name" ]] || name=${first%:*}

# One descriptor for each connection, and some for files.
files=$(ulimit -Hn)
[[ "$files" == unlimited ]] && files=1048576
[[ -n "$connections" ]] || connections=$((files > 8320 ? 8192 : files - 128))
[[ "$connections" -gt 0 ]] || die "$files open files are too few (ulimit -n)"

# Prints the lines of nginx's `upstream`: the current addresses of the coordinators.
servers() {
  local address host port ip
  for address in ${coordinators//,/ }; do
    host=${address%:*} port=${address##*:}
    for ip in $(getent ahosts "$host" | awk '$2 == "STREAM" {print $1}' | sort -u); do
      [[ "$ip" == *:* ]] && ip="[$ip]"
      echo "    server $ip:$port max_fails=1 fail_timeout=1s;"
    done
  done
}

# render FILE: writes the configuration. Fails if no coordinator has an address.
render() {
  local lines
  lines=$(servers)
  [[ -n "$lines" ]] || return 1
  sed -e "/^@$drop /d" -e "s/^@$keep //" -e "s|@DIR@|$dir|g" -e "s|@WORKERS@|auto|" -e "s|@FILES@|$files|" \
    -e "s|@DRAIN@|$drain|" -e "s|@CONNECTIONS@|$connections|" -e "s|@CALLS@|$calls|g" -e "s|@OPEN@|$open|g" \
    -e "s|@UPLOADS@|$uploads|" -e "s|@LISTEN@|$listen|" -e "s|@CERT@|$cert|" -e "s|@KEY@|$key|" -e "s|@CA@|$ca|" \
    -e "s|@VERIFY@|$verify|" -e "s|@SCHEME@|$scheme|" -e "s|@NAME@|$name|" "$here/nginx.conf.in" |
    awk -v lines="$lines" '$0 == "@SERVERS@" { print lines; next } { print }' >"$1"
}

# Prints a checksum of the files that nginx has read.
state() { cat "$1" ${cert:+"$cert" "$key" "$ca"} 2>/dev/null | cksum; }

until render "$dir/nginx.conf"; do
  echo "proxy.sh: no address for $coordinators yet" >&2
  sleep 1
done
# A killed nginx leaves this file, and its process id may belong to another program now.
rm -f "$dir/nginx.pid"
# nginx ends with this script in every case.
setpriv --pdeathsig TERM nginx -p "$dir" -c "$dir/nginx.conf" -e stderr &
nginx=$!
read_last=$(state "$dir/nginx.conf")

ending=0
end() {
  ending=1
  kill -QUIT "$nginx" 2>/dev/null || true
  # nginx normally ends calls after --drain by itself. This command ends it if it does not.
  (sleep $((drain + 5)); kill -TERM "$nginx" 2>/dev/null || true) >/dev/null 2>&1 &
}
trap end TERM INT
until [[ -s "$dir/nginx.pid" ]] || ! kill -0 "$nginx" 2>/dev/null; do sleep 0.05; done
kill -0 "$nginx" 2>/dev/null && echo "listening on $listen"

# Reloads nginx when a certificate was renewed or a name resolves to other addresses.
reload() {
  render "$dir/next.conf" || return 0
  local now
  now=$(state "$dir/next.conf")
  [[ "$now" != "$read_last" ]] || return 0
  nginx -p "$dir" -c "$dir/next.conf" -e stderr -t -q || return 0 # a half-renewed certificate; the rest follows
  mv "$dir/next.conf" "$dir/nginx.conf"
  kill -HUP "$nginx" && read_last=$now
}

while kill -0 "$nginx" 2>/dev/null; do
  sleep 2 &
  wait "$!" || true # a signal ends the wait
  [[ $ending -eq 1 ]] || reload
  [[ $ending -eq 0 ]] || { while kill -0 "$nginx" 2>/dev/null; do wait "$nginx" || true; done; }
done
[[ $ending -eq 1 ]] || die "nginx ended"
