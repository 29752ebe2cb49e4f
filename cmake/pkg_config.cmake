# phrame.pc, for those who do not use CMake. What our headers call is linked by everybody: FLINT, Arb
# where it is a library of its own, MPFR and GMP. fmt and NLopt are linked by whoever links a static
# phrame, and forgotten by a shared one. As phrameConfig.cmake has it.

# -L and -l of a library's file, without -L where linkers look anyway.
function(append_linked_by result file)
  cmake_path(GET file PARENT_PATH folder)
  cmake_path(GET file STEM name)
  string(REGEX REPLACE "^lib" "" name "${name}")
  if(NOT folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
    string(APPEND ${result} " \"-L${folder}\"")
  endif()
  string(APPEND ${result} " -l${name}")
  set(${result} "${${result}}" PARENT_SCOPE)
endfunction()

set(pc_libs)
get_target_property(flint_libraries FLINT::FLINT INTERFACE_LINK_LIBRARIES)
foreach(file IN LISTS flint_libraries)
  append_linked_by(pc_libs "${file}")
endforeach()

set(pc_cflags)
get_target_property(boost_includes Boost::headers INTERFACE_INCLUDE_DIRECTORIES)
get_target_property(flint_includes FLINT::FLINT INTERFACE_INCLUDE_DIRECTORIES)
set(pc_includes ${flint_includes} ${boost_includes})
list(REMOVE_DUPLICATES pc_includes)
foreach(folder IN LISTS pc_includes)
  if(NOT folder IN_LIST CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES)
    string(APPEND pc_cflags " \"-I${folder}\"")
  endif()
endforeach()

# Not Requires.private, for which pkg-config would want fmt.pc of those who need only our headers.
set(pc_requires)
set(pc_libs_private)
if(library_type STREQUAL STATIC_LIBRARY)
  set(pc_requires "fmt, nlopt")
else()
  set(pc_libs_private "-lfmt -lnlopt")
endif()

file(RELATIVE_PATH pc_to_include
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(cmake/phrame.pc.in phrame.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/phrame.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
