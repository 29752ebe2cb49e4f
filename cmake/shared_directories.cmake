# Makes the folders that are installed to readable by everybody, whatever the umask of who installs.
# CMake does so for the files and for what is below a folder that is installed as a whole;
# CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS does not, since mkdir obeys the umask. Folders that exist
# are left alone. To be included before the first install(): install scripts run in their order.
set(installed_to
  ${CMAKE_INSTALL_BINDIR} ${CMAKE_INSTALL_INCLUDEDIR} ${CMAKE_INSTALL_LIBDIR}/cmake/phrame
  ${CMAKE_INSTALL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_DOCDIR} ${CMAKE_INSTALL_DATADIR}/phrame)
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
