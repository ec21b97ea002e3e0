# Links gRPC, Abseil and Protobuf into the programs: to load 50 libraries takes a short job a tenth of its CPU time. Their packages
# have archives, but name only shared libraries to CMake. Builds with sanitizers keep the shared libraries, which the sanitizers'
# suppressions name.
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
  if(target MATCHES "^(absl::|gRPC::(grpc\\+\\+|grpc\\+\\+_reflection|grpc|gpr|upb|address_sorting)$|protobuf::libprotobuf$)")
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      slicefarm_use_archive(${target})
    endif()
  endif()
endforeach()
