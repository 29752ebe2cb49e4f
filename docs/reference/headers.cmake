# cmake -P headers.cmake: the public headers on one line, relative to src/.
include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/public_headers.cmake)
phrame_public_headers(${CMAKE_CURRENT_LIST_DIR}/../../src headers)
list(JOIN headers " " headers)
execute_process(COMMAND ${CMAKE_COMMAND} -E echo ${headers})
