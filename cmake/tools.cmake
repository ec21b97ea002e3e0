# slicefarm_tools(VARIABLE): the compiler, the C library and the libraries with algorithms that affect results, with their
# versions, as `name=version` separated by commas. For cmake/build_info.cmake.
function(slicefarm_tools variable)
  execute_process(COMMAND getconf GNU_LIBC_VERSION OUTPUT_VARIABLE libc OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(REPLACE " " "-" libc "${libc}")
  find_path(CGAL_HEADERS CGAL/version.h REQUIRED)
  file(STRINGS ${CGAL_HEADERS}/CGAL/version.h cgal REGEX "#define CGAL_VERSION_NR ")
  string(REGEX REPLACE "[^0-9]" "" cgal "${cgal}")
  # Debian's .pc file of Clipper has no version.
  find_path(CLIPPER_HEADERS polyclipping/clipper.hpp REQUIRED)
  file(STRINGS ${CLIPPER_HEADERS}/polyclipping/clipper.hpp clipper REGEX "#define CLIPPER_VERSION ")
  string(REGEX REPLACE "[^0-9.]" "" clipper "${clipper}")
  # RE2's .pc file has no useful version either, so the version is read from the name of the library file.
  list(GET libre2_LINK_LIBRARIES 0 re2)
  get_filename_component(re2 ${re2} REALPATH)
  get_filename_component(re2 ${re2} NAME)
  set(tools
    ${CMAKE_CXX_COMPILER_ID}=${CMAKE_CXX_COMPILER_VERSION} ${CMAKE_SYSTEM_PROCESSOR} libc=${libc} absl=${absl_VERSION} boost=${Boost_VERSION}
    cairo=${cairo_VERSION} cgal=${cgal} clipper=${clipper} eigen=${Eigen3_VERSION} expat=${EXPAT_VERSION_STRING} fmt=${fmt_VERSION}
    json=${nlohmann_json_VERSION} png=${PNG_VERSION_STRING} protobuf=${Protobuf_VERSION} re2=${re2} zip=${libzip_VERSION})
  foreach(tool ${tools})
    if(tool MATCHES "=$")
      message(FATAL_ERROR "the version of ${tool} is not known")
    endif()
  endforeach()
  list(JOIN tools "," tools)
  set(${variable} "${tools}" PARENT_SCOPE)
endfunction()
