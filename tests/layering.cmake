# cmake -P layering.cmake
# Holds the layering of src/, by its preprocessor lines and, without comments, its text:
#   - a file includes, as "phrame/<room>/<file>.hpp", only its own room and those below it;
#   - what writes sees answers and values, and nothing that evaluates them;
#   - only algebra/flint.hpp includes headers of FLINT and Arb, and those of polynomials in several unknowns
#     algebra/flint_multivariate.hpp; only the first has #if, and algebra/wide.hpp, which asks for the processor;
#   - only algebra calls FLINT and Arb, names their types and asks ours for them by raw();
#   - a header starts with #pragma once, and what src/phrame.hpp reaches needs no private dependency;
#   - of the library python/src includes what src/phrame.hpp reaches, by that header, and of the insides what its
#     insides.hpp lists, but for its ask.cpp, which asks what the program is asked, by cli/ask.hpp;
#     and it keeps to Python's stable ABI, which has no macros such as PyList_GET_SIZE.

cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../cmake/public_headers.cmake)

cmake_path(SET SOURCE_DIR NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../src)
# From below to above; a folder of `ph` or `io` is a room, and what lies in io itself sees both of its.
set(rooms algebra integrate ph/curve ph/along ph/frame ph/twist ph/construct ph/proof ph/sweep ph/offset answer io/write io/read io cli)
# What io/write may include: the values that answers are made of, with the polynomials of a curve.
set(value_header "^(algebra|answer|io/write)/\
|^integrate/(antiderivative|exact_value|other_form|path_end|pole_table|radicals|real_form)\\.hpp$\
|^ph/curve/(corner|curve|hodograph_fraction|invariants|named|nearness|path|ph_path|quaternion|rational_curve|special_points|vector)\\.hpp$\
|^ph/along/frame_angle\\.hpp$\
|^ph/frame/frame_start\\.hpp$\
|^ph/proof/(certificate|integral_certificate|statement)\\.hpp$\
|^ph/sweep/(mesh|mesh_sink|rational_surface)\\.hpp$")
set(flint_header "^(flint/.+|(acb|arb|arf|mag|fmpr|fmpz|fmpq|bool_mat|dlog|dirichlet|bernoulli\
|hypgeom|partitions|double_interval)[a-z_]*\\.h)$")
set(flint_name "_?(arb|acb|arf|mag|fmpr|fmpz|fmpzi|fmpq|nmod|flint)_[a-z][a-z0-9_]*\
|(ARB|ACB|ARF|MAG|FMPZ|FMPQ|NMOD|COEFF|FLINT)_[A-Z0-9_]+|slong|ulong|fmpz|fmpq|flint::|raw\\(\\)")
set(private_header "^(nlohmann|fmt|CLI|Eigen)/")

set(violations 0)
macro(violation)
  message("src/${file}: ${ARGN}")
  math(EXPR violations "${violations} + 1")
endmacro()

# The preprocessor lines of a file, without the characters that mean something in a list.
function(read_directives file result)
  file(READ ${SOURCE_DIR}/${file} text)
  string(REGEX REPLACE "[][;\\]" "" text "\n${text}")
  string(REGEX MATCHALL "\n[ \t]*#[^\n]*" lines "${text}")
  list(TRANSFORM lines STRIP)
  set(${result} "${lines}" PARENT_SCOPE)
endfunction()

# What a file above algebra has of FLINT in its text, each name once.
function(read_flint_names file result)
  file(READ ${SOURCE_DIR}/${file} text)
  string(REGEX REPLACE "//[^\n]*" "" text "\n${text}")
  string(REGEX MATCHALL "[^A-Za-z0-9_](${flint_name})" names "${text}")
  list(TRANSFORM names REPLACE "^[^A-Za-z0-9_]" "")
  list(REMOVE_DUPLICATES names)
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/*.hpp ${SOURCE_DIR}/*.cpp)
if(NOT files)
  message(FATAL_ERROR "no sources in ${SOURCE_DIR}")
endif()

foreach(file IN LISTS files)
  read_directives(${file} directives)
  cmake_path(GET file PARENT_PATH room)
  list(FIND rooms "${room}" height)
  if(file MATCHES "^(phrame|fwd)\\.hpp$")
    list(LENGTH rooms height)
  elseif(height EQUAL -1)
    violation("is in no room (${rooms})")
  endif()
  if(file MATCHES "\\.hpp$" AND NOT "#pragma once" IN_LIST directives)
    violation("lacks #pragma once")
  endif()
  if(NOT room STREQUAL algebra)
    read_flint_names(${file} names)
    foreach(name IN LISTS names)
      violation("${name}: only algebra calls FLINT and Arb")
    endforeach()
  endif()

  foreach(directive IN LISTS directives)
    if(directive MATCHES "^#[ \t]*(if|el|endif)" AND NOT file MATCHES "^algebra/(flint|wide)\\.hpp$")
      violation("${directive}: only algebra/flint.hpp and algebra/wide.hpp decide by preprocessor")
    endif()
    if(NOT directive MATCHES "^#[ \t]*include(.*)")
      continue()
    endif()
    string(STRIP "${CMAKE_MATCH_1}" header)
    if(header MATCHES "^\"phrame/(version|export|fwd)\\.hpp\"")
      continue()
    elseif(header MATCHES "^\"phrame/([^\"]+)/[^/\"]+\"")
      list(FIND rooms ${CMAKE_MATCH_1} included)
      if(included EQUAL -1 OR included GREATER height)
        violation("${directive}: not in its own room or below")
      endif()
      string(REGEX REPLACE "^\"phrame/(.*)\".*" "\\1" included ${header})
      if(room STREQUAL io/write AND NOT included MATCHES "${value_header}")
        violation("${directive}: it evaluates, and what writes only writes")
      endif()
    elseif(header MATCHES "^<phrame/" OR NOT header MATCHES "^<([^>]+)>")
      violation("${directive}: ours are included as \"phrame/<room>/<file>.hpp\", others in <>")
    elseif(CMAKE_MATCH_1 MATCHES "${flint_header}" AND NOT file MATCHES "^algebra/flint(_multivariate)?\\.hpp$")
      violation("${directive}: only algebra/flint.hpp includes FLINT and Arb")
    elseif(CMAKE_MATCH_1 MATCHES "\\.hxx$")
      violation("${directive}: only step/ includes Open CASCADE")
    endif()
  endforeach()
endforeach()

phrame_public_headers(${SOURCE_DIR} public_headers)
foreach(file IN LISTS public_headers)
  read_directives(${file} directives)
  foreach(directive IN LISTS directives)
    if(directive MATCHES "<([^>]+)>" AND CMAKE_MATCH_1 MATCHES "${private_header}")
      violation("${directive}: is reached from phrame.hpp, so a user of the library would need it")
    endif()
  endforeach()
endforeach()

# The Python package is a user of the library like any other.
file(GLOB files RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/../python/src/*.hpp ${SOURCE_DIR}/../python/src/*.cpp)
foreach(file IN LISTS files)
  read_directives(${file} directives)
  read_flint_names(${file} names)
  foreach(name IN LISTS names)
    violation("${name}: only algebra calls FLINT and Arb")
  endforeach()
  file(READ ${SOURCE_DIR}/${file} text)
  if(text MATCHES "Py[A-Z][A-Za-z_]*_[A-Z][A-Z_]+\\(")
    violation("${CMAKE_MATCH_0}): is no part of Python's stable ABI")
  endif()
  foreach(directive IN LISTS directives)
    if(directive MATCHES "[<\"](phrame/.*)[>\"]" AND NOT CMAKE_MATCH_1 STREQUAL "phrame/phrame.hpp"
        AND NOT file MATCHES "/insides\\.hpp$" AND NOT (file MATCHES "/ask\\.cpp$" AND directive MATCHES "phrame/cli/ask\\.hpp"))
      violation("${directive}: the package includes phrame/phrame.hpp, and insides by its insides.hpp")
    elseif(directive MATCHES "<([^>]+)>" AND CMAKE_MATCH_1 MATCHES "${private_header}|${flint_header}")
      violation("${directive}: what the library is made with is its own matter")
    endif()
  endforeach()
endforeach()

if(violations)
  message(FATAL_ERROR "${violations} violations of the layering")
endif()
