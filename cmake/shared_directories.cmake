# Makes the folders that are installed to readable by everybody, whatever the umask of who installs.
# CMake does so for the files and for what is below a folder that is installed as a whole;
# CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS does not, since mkdir obeys the umask. Folders that exist
# are left alone. To be included before the first install(): install scripts run in their order.
set(installed_to
  ${CMAKE_INSTALL_BINDIR} ${CMAKE_INSTALL_INCLUDEDIR} ${CMAKE_INSTALL_LIBDIR}/cmake/phrame
  ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_DOCDIR} ${CMAKE_INSTALL_DATADIR}/phrame)
include(${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake)
phrame_public_headers(${PROJECT_SOURCE_DIR}/src headers)
foreach(header IN LISTS headers)
  get_filename_component(room ${header} DIRECTORY)
  list(APPEND installed_to ${CMAKE_INSTALL_INCLUDEDIR}/phrame/${room})
endforeach()
list(REMOVE_DUPLICATES installed_to)
install(CODE "set(installed_to ${installed_to})")
install(CODE [[
  foreach(folder IN LISTS installed_to)
    cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX})
    set(folder "$ENV{DESTDIR}${folder}")
    set(new)
    while(NOT EXISTS "${folder}")
      list(PREPEND new "${folder}")
      cmake_path(GET folder PARENT_PATH folder)
    endwhile()
    foreach(folder IN LISTS new)
      file(MAKE_DIRECTORY "${folder}")
      file(CHMOD "${folder}" PERMISSIONS
        OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
    endforeach()
  endforeach()]])
