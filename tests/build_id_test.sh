#!/usr/bin/env bash
# The build id follows what a program is made of, and nothing else: tests cmake/build_info.cmake on a small tree.
set -euo pipefail
cd "$(dirname "$0")/.."

tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree"/{common,services,proto,cmake}
cp CMakeLists.txt "$tree"
cp cmake/*.cmake "$tree/cmake"
touch "$tree"/common/a.{h,cc} "$tree"/services/a_test.{h,cc} "$tree"/proto/a.proto
echo '@BUILD_ID@' > "$tree/id.in"

build_id() {
  cmake -D SOURCE_DIR="$tree" -D TEMPLATE="$tree/id.in" -D OUTPUT="$tree/id" -P cmake/build_info.cmake
  cat "$tree/id"
}

fail() {
  echo "FAILED: $*"
  exit 1
}

first=$(build_id)
[[ $first =~ ^[0-9a-f]{16}$ ]] || fail "not a build id: $first"
for file in services/a_test.h services/a_test.cc; do
  echo "// changed" >> "$tree/$file"
  [[ $(build_id) == "$first" ]] || fail "$file is a test and changes the build id"
done
for file in common/a.h common/a.cc proto/a.proto CMakeLists.txt cmake/targets.cmake; do
  before=$(build_id)
  echo "# changed" >> "$tree/$file"
  [[ $(build_id) != "$before" ]] || fail "$file does not change the build id"
done
echo "passed"
