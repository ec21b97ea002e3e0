# There are four precompiled headers, each made once. Without them a clean build takes twice as long.
option(SLICEFARM_PCH "Precompile what nearly every file includes" ON)

# slicefarm_precompiled(name header [FAST] DEPS ...): makes a precompiled header. FAST: for targets of slicefarm_compile_fast.
function(slicefarm_precompiled name header)
  cmake_parse_arguments(ARG "FAST" "" "DEPS" ${ARGN})
  if(NOT SLICEFARM_PCH)
    return()
  endif()
  file(WRITE ${CMAKE_BINARY_DIR}/pch/${name}.cc "")
  add_library(${name} STATIC ${CMAKE_BINARY_DIR}/pch/${name}.cc)
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ARG_DEPS} PRIVATE slicefarm_warnings)
  target_precompile_headers(${name} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/pch/${header})
  if(ARG_FAST) # a precompiled header must have the same flags as its user
    slicefarm_compile_fast(${name})
  endif()
endfunction()

# Algorithms are compiled with -O2, and so are messages and their conversion: with -O1 a job on a farm takes 4 % longer. Tests run
# only briefly, and code with gRPC mostly waits for other processes, so they are compiled with -O1. This saves a quarter of the
# compile time.
function(slicefarm_compile_fast target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Selects the precompiled header of a target: one with gRPC if a library that the target links has it.
function(slicefarm_use_precompiled target kind)
  set(grpc "")
  set(libraries ${ARGN})
  list(REMOVE_ITEM libraries slicefarm_load_algo slicefarm_postgres_server)  # libraries without gRPC in spite of their names
  if("${libraries}" MATCHES "slicefarm_(rpc|proto|cli|load|integration_support)|_server|_remote|grpc")
    set(grpc "_grpc")
    if(kind STREQUAL library)
      slicefarm_compile_fast(${target})
    endif()
  endif()
  if(SLICEFARM_PCH)
    target_precompile_headers(${target} REUSE_FROM slicefarm_pch${grpc}_${kind})
  endif()
endfunction()

# The cold preset compiles up to 64 files of a target, usually all, as one. Headers and templates, which are most of a compiler's
# work, are then processed once. So all files of a library or a program need different names in their unnamed namespaces. A test
# has a namespace named like its file, so its helpers may have any names. For repeated builds use the release preset, which
# compiles each changed file alone.

# slicefarm_library(name SOURCES a.cc b.cc DEPS x y): one library per folder, with the name of its path.
function(slicefarm_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPS;PRIVATE_DEPS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${ARG_DEPS} PRIVATE ${ARG_PRIVATE_DEPS} slicefarm_warnings)
  slicefarm_use_precompiled(${name} library ${ARG_DEPS} ${ARG_PRIVATE_DEPS})
endfunction()

# The programs of a farm, and its command line.
add_custom_target(programs)

# slicefarm_binary(slicefarm-x [LIBC_HEAP] [ON_DEMAND] SOURCES main.cc DEPS ...): a program in build/bin. It belongs to the target
# `programs`, unless ON_DEMAND.
function(slicefarm_binary name)
  cmake_parse_arguments(ARG "LIBC_HEAP;ON_DEMAND" "" "SOURCES;DEPS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(${name} PRIVATE ${ARG_DEPS} slicefarm_warnings)
  slicefarm_use_precompiled(${name} library ${ARG_DEPS})
  if(NOT ARG_LIBC_HEAP)
    target_link_libraries(${name} PRIVATE slicefarm_heap)
  endif()
  if(NOT ARG_ON_DEMAND)
    add_dependencies(programs ${name})
    install(TARGETS ${name})
  endif()
endfunction()

# slicefarm_test(name SOURCES a_test.cc b_test.cc DEPS ... [LABELS slow]): the tests of one folder, as one process.
function(slicefarm_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPS;LABELS" ${ARGN})
  if(NOT BUILD_TESTING)
    return()
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${name} PRIVATE SLICEFARM_CORPUS="${PROJECT_SOURCE_DIR}/tests/corpus")
  target_link_libraries(${name} PRIVATE ${ARG_DEPS} slicefarm_warnings GTest::gmock GTest::gtest_main)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests)
  slicefarm_compile_fast(${name})
  slicefarm_use_precompiled(${name} test ${ARG_DEPS})
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}")
endfunction()
