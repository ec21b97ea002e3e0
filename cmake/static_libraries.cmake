# Links libraries into the programs: to load 80 of them takes a short job a tenth of its CPU time. Their packages have archives, but
# name only shared libraries to CMake. Libraries that read files of users (expat, PNG, JPEG, zip) stay shared, so that a security
# update of the system reaches them. Builds with sanitizers keep all shared libraries, which the sanitizers' suppressions name.
if(SLICEFARM_SANITIZE OR SLICEFARM_FUZZ)
  return()
endif()

# Makes an imported target stand for the archive beside its shared library, if there is one.
function(slicefarm_use_archive target)
  get_target_property(configurations ${target} IMPORTED_CONFIGURATIONS)
  foreach(suffix "" ${configurations})
    string(REGEX REPLACE "(.+)" "_\\1" suffix "${suffix}")
    get_target_property(library ${target} IMPORTED_LOCATION${suffix})
    if(NOT library)
      continue()
    endif()
    string(REGEX REPLACE "\\.so[.0-9]*$" ".a" archive "${library}")
    if(EXISTS "${archive}")
      set_target_properties(${target} PROPERTIES IMPORTED_LOCATION${suffix} "${archive}")
    endif()
  endforeach()
endfunction()

get_directory_property(imported IMPORTED_TARGETS)
foreach(target ${imported})
  if(target MATCHES "^(absl::|gRPC::(grpc\\+\\+|grpc\\+\\+_reflection|grpc|gpr|upb|address_sorting)$|protobuf::libprotobuf$|c-ares::cares$)")
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      slicefarm_use_archive(${target})
    endif()
  endif()
endforeach()

# Returns the archives of the named libraries, or an empty list if one is missing.
function(slicefarm_find_archives result)
  set(archives "")
  foreach(name ${ARGN})
    find_library(archive_of_${name} NAMES lib${name}.a)
    mark_as_advanced(archive_of_${name})
    if(NOT archive_of_${name})
      set(${result} "" PARENT_SCOPE)
      return()
    endif()
    list(APPEND archives "${archive_of_${name}}")
  endforeach()
  set(${result} "${archives}" PARENT_SCOPE)
endfunction()

# Adds the target slicefarm::NAME of an archive that was found. Further arguments: the libraries that it needs; CMake puts them
# behind the archive in each link command.
function(slicefarm_add_archive name)
  add_library(slicefarm::${name} STATIC IMPORTED)
  set_target_properties(slicefarm::${name} PROPERTIES
    IMPORTED_LOCATION "${archive_of_${name}}" INTERFACE_LINK_LIBRARIES "${ARGN}")
endfunction()

# Only pictures need Cairo, and only textures SuiteSparse, but their shared libraries load 25 others, such as X11 and LAPACK.
slicefarm_find_archives(cairo_archives cairo pixman-1 fontconfig freetype)
if(cairo_archives)
  slicefarm_add_archive(freetype brotlidec PNG::PNG ZLIB::ZLIB)
  slicefarm_add_archive(fontconfig slicefarm::freetype EXPAT::EXPAT)
  slicefarm_add_archive(cairo slicefarm::fontconfig "${archive_of_pixman-1}" PNG::PNG)
  set_target_properties(PkgConfig::cairo PROPERTIES INTERFACE_LINK_LIBRARIES slicefarm::cairo)
endif()
slicefarm_find_archives(cholmod_archives cholmod amd colamd camd ccolamd suitesparseconfig)
find_library(METIS NAMES metis libmetis.so.5)
if(cholmod_archives AND METIS)
  set(CHOLMOD "${cholmod_archives};${METIS}")
endif()
slicefarm_find_archives(jemalloc_archive jemalloc)
if(jemalloc_archive)
  set_target_properties(PkgConfig::jemalloc PROPERTIES INTERFACE_LINK_LIBRARIES "${jemalloc_archive};${CMAKE_DL_LIBS}")
endif()
