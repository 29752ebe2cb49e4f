# phrame_step(): the library by which `phrame sweep --exact` writes STEP, made with Open CASCADE. It is loaded when
# it is asked for, so that nothing else needs it. Where there is no Open CASCADE phrame is built without, and says
# so here and when STEP is asked for.
set(default ${PROJECT_IS_TOP_LEVEL})
if(SKBUILD)
  set(default OFF)
endif()
option(PHRAME_BUILD_STEP "Build what writes STEP files, where there is Open CASCADE" ${default})

# Not by its own package for CMake, which asks for all of it, its viewer too. Since 7.8 STEP is in TKDESTEP, all of it.
function(phrame_step)
  if(NOT PHRAME_BUILD_STEP)
    return()
  endif()
  find_path(PHRAME_OCCT_INCLUDE STEPControl_Writer.hxx PATH_SUFFIXES opencascade occt)
  find_library(PHRAME_OCCT_STEP NAMES TKDESTEP TKSTEP)
  find_library(PHRAME_OCCT_STEP_DATA NAMES TKDESTEP TKSTEPBase)
  mark_as_advanced(PHRAME_OCCT_INCLUDE PHRAME_OCCT_STEP PHRAME_OCCT_STEP_DATA)
  set(libraries ${PHRAME_OCCT_STEP} ${PHRAME_OCCT_STEP_DATA})
  foreach(name IN ITEMS TKXSBase TKShHealing TKTopAlgo TKBRep TKG3d TKMath TKernel)
    find_library(PHRAME_OCCT_${name} ${name})
    mark_as_advanced(PHRAME_OCCT_${name})
    list(APPEND libraries ${PHRAME_OCCT_${name}})
  endforeach()
  if(NOT PHRAME_OCCT_INCLUDE OR libraries MATCHES NOTFOUND)
    message(STATUS "phrame sweep will write no STEP: it needs Open CASCADE (docs/dependencies.md)")
    return()
  endif()
  add_library(phrame_occt INTERFACE)
  target_include_directories(phrame_occt SYSTEM INTERFACE ${PHRAME_OCCT_INCLUDE})
  target_link_libraries(phrame_occt INTERFACE ${libraries})
  add_library(phrame_step MODULE step/step_writer.cpp)
  target_compile_features(phrame_step PRIVATE cxx_std_20)
  # Of phrame it has the types of one header, and no code.
  target_include_directories(phrame_step PRIVATE ${PROJECT_BINARY_DIR}/include)
  target_link_libraries(phrame_step PRIVATE phrame_occt)
  set_target_properties(phrame_step PROPERTIES PREFIX ""
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin/${bin_to_lib}/phrame)
  # A folder that shared_directories.cmake does not know, for everybody to read.
  install(CODE "set(step_folder [[${CMAKE_INSTALL_LIBDIR}/phrame]])")
  install(CODE [[
    cmake_path(ABSOLUTE_PATH step_folder BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX})
    file(MAKE_DIRECTORY "$ENV{DESTDIR}${step_folder}")
    file(CHMOD "$ENV{DESTDIR}${step_folder}" PERMISSIONS
      OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)]])
  install(TARGETS phrame_step LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/phrame)
endfunction()
