# cmake -D SOURCE_DIR=.. -D TEMPLATE=.. -D OUTPUT=.. -D VERSION=.. -D RELEASE_DATE=.. -P build_info.cmake
#
# Fills in common/base/build_info.cc.in. The build id is a digest over the names and contents of all files that decide
# what the programs compute, not over a commit: an image is built from a copy of the tree without its repository. A file *_test.{h,cc} is in no program,
# so a changed test neither empties the cache nor parts a worker from its coordinator.
file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR}
  ${SOURCE_DIR}/common/*.h ${SOURCE_DIR}/common/*.cc ${SOURCE_DIR}/common/*.in
  ${SOURCE_DIR}/services/*.h ${SOURCE_DIR}/services/*.cc
  ${SOURCE_DIR}/proto/*.proto)
list(FILTER files EXCLUDE REGEX "_test\\.(cc|h)$")
list(APPEND files CMakeLists.txt cmake/targets.cmake cmake/build_info.cmake)
list(SORT files)

set(listing "")
foreach(file ${files})
  file(SHA256 ${SOURCE_DIR}/${file} digest)
  string(APPEND listing "${digest}  ${file}\n")
endforeach()
string(SHA256 BUILD_ID "${listing}")
string(SUBSTRING ${BUILD_ID} 0 16 BUILD_ID)

configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
