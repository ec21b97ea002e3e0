#!/usr/bin/env bash
# Installs the packages that slicefarm needs on a Debian 12 machine, from Debian only. It can be run again: it does nothing
# if all packages are installed.
#
#   deploy/setup.sh            to build and test
#   deploy/setup.sh runtime    only the packages for running the finished programs (used by the image)
set -euo pipefail

build=(
  build-essential git cmake ninja-build ccache pkg-config python3 python3-yaml python3-grpcio python3-protobuf
  libgrpc++-dev protobuf-compiler-grpc libprotobuf-dev protobuf-compiler libabsl-dev
  libboost-dev libpolyclipping-dev libeigen3-dev libcgal-dev liblemon-dev libsuitesparse-dev libexpat1-dev libzip-dev
  libfmt-dev libspdlog-dev libcli11-dev nlohmann-json3-dev prometheus-cpp-dev libcivetweb-dev libmicrohttpd-dev
  libsqlite3-dev sqlite3 libpq-dev postgresql-15 libcurl4-openssl-dev libssl-dev libpng-dev libjpeg-dev libqoi-dev zlib1g-dev libcairo2-dev libseccomp-dev
  libjemalloc-dev libre2-dev nginx
  libgtest-dev libgmock-dev
  clang clang-format clang-tidy libclang-rt-14-dev
)
runtime=(
  libpolyclipping22 libspdlog1.10 libprometheus-cpp-core1.0 libmicrohttpd12
  ca-certificates libsqlite3-0 sqlite3 libpq5 libcurl4 libssl3 libpng16-16 libjpeg62-turbo zlib1g libbrotli1 libseccomp2 fontconfig-config
  libexpat1 libzip4 libre2-9 libmetis5 nginx
)

packages=("${build[@]}")
[[ "${1:-}" == runtime ]] && packages=("${runtime[@]}")

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

echo "installing: ${missing[*]}"
as_root=()
[[ $(id -u) -eq 0 ]] || as_root=(sudo)
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
# A service manager would start nginx on port 80. This is not wanted, because deploy/proxy starts its own nginx.
[[ " ${missing[*]} " != *" nginx "* ]] || "${as_root[@]}" systemctl disable --now nginx >/dev/null 2>&1 || true
