#!/usr/bin/env bash
# Makes certificates for development and tests: a CA of its own, and one certificate for each role, signed by this CA. A
# real farm has its own CA, which gives the same identities (URI) and keeps its key elsewhere.
#
#   deploy/dev-certs.sh DIR [--days N] [ROLE...]
#
# ROLE     coordinator, proxy, worker, stage/slicing and so on, tenant/NAME. Default: all roles of slicefarm, and tenant/dev.
# --days   days of validity (30). 0: already expired.
# Output: DIR/ROLE/{cert,key,ca}.pem (with - for / in the role), a directory that can be mounted as a whole, and the CA in
# DIR/ca. An existing CA is reused. An existing role gets a new certificate by renaming, so that a running program finds
# either the old pair or the new one.
set -euo pipefail

usage() { sed -n '2,13s/^# \{0,1\}//p' "$0"; exit 2; }
[[ $# -ge 1 && $1 != -* ]] || usage
dir=$1 days=30 roles=()
shift
while [[ $# -gt 0 ]]; do
  case "$1" in
    --days) days=${2:?}; shift 2 ;;
    -*) usage ;;
    *) roles+=("$1"); shift ;;
  esac
done
[[ "$days" =~ ^[0-9]+$ ]] || usage
stages=(slicing planning beading infill ordering motion exposure milling texture)
[[ ${#roles[@]} -gt 0 ]] || roles=(coordinator proxy worker "${stages[@]/#/stage/}" tenant/dev)

umask 077
mkdir -p "$dir"
work=$(mktemp -d "$dir/.new-XXXXXX")
trap 'rm -rf "$work"' EXIT

new_key() { openssl ecparam -name prime256v1 -genkey -noout -out "$1"; }

if [[ ! -s "$dir/ca/ca.pem" ]]; then
  mkdir "$work/ca"
  new_key "$work/ca/key.pem"
  openssl req -x509 -new -key "$work/ca/key.pem" -days 3650 -subj "/O=slicefarm/CN=slicefarm development CA" \
    -addext basicConstraints=critical,CA:TRUE -addext keyUsage=critical,keyCertSign,cRLSign -out "$work/ca/ca.pem"
  mv "$work/ca" "$dir/ca"
fi

# Prints the names of the role's servers on this machine and in the compose files. Only clients that address a server by name
# check them. The coordinator identifies its stages by their URI, at any address.
names_of() {
  case "$1" in
    tenant/*) ;;
    *) echo ",DNS:localhost,DNS:${1##*/},IP:127.0.0.1,IP:::1" ;;
  esac
}

for role in "${roles[@]}"; do
  [[ "$role" =~ ^(coordinator|proxy|worker|stage/[a-z]+|tenant/[a-z0-9][a-z0-9_-]*)$ ]] ||
    { echo "dev-certs.sh: there is no role '$role'" >&2; exit 2; }
  name=${role//\//-} new=$work/${role//\//-}
  mkdir "$new"
  new_key "$new/key.pem"
  # A tenant's certificate is not valid for servers, so that no tenant can pretend to be the coordinator.
  use=serverAuth,clientAuth
  [[ "$role" == tenant/* ]] && use=clientAuth
  openssl req -new -key "$new/key.pem" -subj "/O=slicefarm/CN=$name" -out "$work/request.pem"
  openssl x509 -req -in "$work/request.pem" -CA "$dir/ca/ca.pem" -CAkey "$dir/ca/key.pem" \
    -set_serial "0x$(openssl rand -hex 16)" -days "$days" -out "$new/cert.pem" -extfile <(
      echo "basicConstraints=critical,CA:FALSE"
      echo "keyUsage=critical,digitalSignature"
      echo "extendedKeyUsage=$use"
      echo "subjectAltName=URI:spiffe://slicefarm/$role$(names_of "$role")"
    ) 2>/dev/null
  cp "$dir/ca/ca.pem" "$new/ca.pem"
  # The name is a link, because a link can be replaced atomically.
  version=.$name-$(openssl rand -hex 4)
  old=$(readlink "$dir/$name" || true)
  mv "$new" "$dir/$version"
  ln -s "$version" "$work/link"
  mv -T "$work/link" "$dir/$name"
  [[ -z "$old" ]] || rm -rf "${dir:?}/$old"
done
