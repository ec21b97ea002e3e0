# cmake -D SOURCE_DIR=.. -D TOOLS=.. -D TEMPLATE=.. -D OUTPUT=.. -D VERSION=.. -D RELEASE_DATE=.. -P build_info.cmake
#
# Fills in common/base/build_info.cc.in. The build id is a digest over all that decides what a job comes to, and nothing else: a
# result stays in the cache, and a worker beside its coordinator, as long as it is the same. These are
#   the names and contents of the files of the stages, and of what they include: not of the command line, the console, the load
#   generator, webhooks, stores and the services that clients call, nor of tests (*_test.{h,cc}, which are in no program)
#   TOOLS: the compiler, the C library and the libraries whose algorithms have a part in it, with their versions
# It is over contents, not over a commit: an image is built from a copy of the tree without its repository.
set(folders
  common/base common/geometry common/macro common/model common/config common/stage common/wire
  services/slicing services/planning services/beading services/infill services/ordering services/motion services/exposure services/milling services/worker
  services/coordinator/algo/pipeline processes)
set(files "")
foreach(folder ${folders})
  file(GLOB_RECURSE found RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.cc)
  if(NOT found)
    message(FATAL_ERROR "build_info.cmake: there is nothing in ${folder}")
  endif()
  list(APPEND files ${found})
endforeach()
list(FILTER files EXCLUDE REGEX "_test\\.(cc|h)$")
# What stages and coordinators say to each other; what clients say is read before a job's digest is taken.
file(GLOB protos RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/proto/slicefarm/v1/*.proto)
list(FILTER protos EXCLUDE REGEX "/(jobs|profiles|error_reason)\\.proto$")
list(APPEND files ${protos} CMakeLists.txt cmake/targets.cmake cmake/build_info.cmake)
list(SORT files)

set(listing "${TOOLS}\n")
foreach(file ${files})
  file(SHA256 ${SOURCE_DIR}/${file} digest)
  string(APPEND listing "${digest}  ${file}\n")
endforeach()
string(SHA256 BUILD_ID "${listing}")
string(SUBSTRING ${BUILD_ID} 0 16 BUILD_ID)

configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
