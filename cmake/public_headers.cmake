# phrame_public_headers(<source directory> <variable>): the headers that phrame.hpp reaches, and those that
# a program includes by themselves, relative to src/.
cmake_policy(VERSION 3.25)  # an installation sets none

function(phrame_public_headers source_dir result)
  set(reached)
  set(todo phrame.hpp fwd.hpp algebra/multiprecision.hpp)
  while(todo)
    list(POP_FRONT todo file)
    if(file IN_LIST reached OR file MATCHES "^(version|export)\\.hpp$")  # which CMake writes
      continue()
    endif()
    list(APPEND reached ${file})
    file(STRINGS ${source_dir}/${file} directives REGEX "^#[ \t]*include[ \t]*\"phrame/[^\"]+\"")
    foreach(directive IN LISTS directives)
      string(REGEX REPLACE ".*\"phrame/([^\"]+)\".*" "\\1" included "${directive}")
      list(APPEND todo ${included})
    endforeach()
  endwhile()
  set(${result} ${reached} PARENT_SCOPE)
endfunction()
