# Run by an installation, which knows CMAKE_INSTALL_PREFIX; source_dir and header_dir are set before.
include(${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake)
phrame_public_headers(${source_dir} headers)
foreach(header IN LISTS headers)
  get_filename_component(room ${header} DIRECTORY)
  file(INSTALL ${source_dir}/${header} DESTINATION "${CMAKE_INSTALL_PREFIX}/${header_dir}/${room}")
endforeach()
