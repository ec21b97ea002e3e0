# cmake -D SOURCE_DIR=.. -D TOOLS=.. -D TEMPLATE=.. -D OUTPUT=.. -D VERSION=.. -D RELEASE_DATE=.. -P build_info.cmake
#
# Fills in common/base/build_info.cc.in. The build id is a digest over everything that affects the bytes of a result, and over
# nothing else. As long as it stays the same, cached results stay valid and a worker may serve a coordinator. It covers:
#   all sources of common, processes and services, except the folders of `left_out` and tests (*_test.{h,cc}). A new folder is
#     covered without being named.
#   TOOLS: the compiler, the C library and the libraries with algorithms that affect results, with their versions.
# It covers contents and no commit, because an image is built from a copy of the tree without its repository.
# With -D LISTING=FILE it also writes the names of the covered files, one per line.
set(left_out
  common/rpc                                    # transports messages
  services/cli services/lab                     # user interfaces
  services/coordinator/algo/[^/]+$ services/coordinator/algo/dispatch   # decide when and where a task runs
  services/coordinator/remote services/coordinator/run services/coordinator/server services/coordinator/store)
set(files "")
foreach(folder common processes services)
  file(GLOB_RECURSE found RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.cc)
  list(APPEND files ${found})
endforeach()
foreach(folder ${left_out})
  list(LENGTH files before)
  list(FILTER files EXCLUDE REGEX "^${folder}")
  list(LENGTH files after)
  if(before EQUAL after)
    message(FATAL_ERROR "build_info.cmake: there is nothing in ${folder}")
  endif()
endforeach()
list(FILTER files EXCLUDE REGEX "_test\\.(cc|h)$")
# Messages between stages and coordinators. Messages of clients are left out, because they are read before a job's digest is
# computed.
file(GLOB protos RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/proto/slicefarm/v1/*.proto)
list(FILTER protos EXCLUDE REGEX "/(jobs|profiles|error_reason)\\.proto$")
list(APPEND files ${protos} CMakeLists.txt cmake/targets.cmake cmake/build_info.cmake)
list(SORT files)

if(DEFINED LISTING)
  list(JOIN files "\n" names)
  file(WRITE ${LISTING} "${names}\n")
endif()

set(listing "${TOOLS}\n")
foreach(file ${files})
  file(SHA256 ${SOURCE_DIR}/${file} digest)
  string(APPEND listing "${digest}  ${file}\n")
endforeach()
string(SHA256 BUILD_ID "${listing}")
string(SUBSTRING ${BUILD_ID} 0 16 BUILD_ID)

configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
