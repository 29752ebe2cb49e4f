# FindFLINT: the target FLINT::FLINT is FLINT with Arb, MPFR and GMP, whichever way they come:
#   FLINT 2.9 and Arb 2.23, two libraries: headers <flint/fmpq_poly.h>, <arb.h>;
#                           libraries flint and flint-arb (Debian's name) or arb
#   FLINT 3, which contains Arb:           headers <flint/fmpq_poly.h>, <flint/arb.h>; library flint
# FLINT_ROOT (a variable of CMake or of the environment) is looked at first, for all four.
# Sets FLINT_FOUND and FLINT_VERSION.

find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
find_path(MPFR_INCLUDE_DIR mpfr.h)
find_library(MPFR_LIBRARY mpfr)
find_path(GMP_INCLUDE_DIR gmp.h)
find_library(GMP_LIBRARY gmp)

set(FLINT_required FLINT_LIBRARY FLINT_INCLUDE_DIR
  MPFR_LIBRARY MPFR_INCLUDE_DIR GMP_LIBRARY GMP_INCLUDE_DIR)
set(FLINT_trouble)

if(FLINT_INCLUDE_DIR)
  # Three macros hold the version; the string FLINT_VERSION has changed its form over the years.
  set(FLINT_VERSION)
  foreach(part IN ITEMS "" _MINOR _PATCHLEVEL)
    set(pattern "^#[ \t]*define[ \t]+__FLINT_VERSION${part}[ \t]+([0-9]+)")
    file(STRINGS ${FLINT_INCLUDE_DIR}/flint/flint.h line REGEX ${pattern})
    if(line MATCHES ${pattern})
      list(APPEND FLINT_VERSION ${CMAKE_MATCH_1})
    endif()
  endforeach()
  list(JOIN FLINT_VERSION . FLINT_VERSION)

  if(FLINT_VERSION STREQUAL "")
    set(FLINT_trouble "${FLINT_INCLUDE_DIR}/flint/flint.h does not tell its version")
  elseif(FLINT_VERSION VERSION_LESS 2.9)
    set(FLINT_trouble
      "FLINT ${FLINT_VERSION} in ${FLINT_INCLUDE_DIR} is too old: 2.9 with Arb 2.23, or 3, is needed")
  elseif(FLINT_VERSION VERSION_LESS 3)
    find_path(ARB_INCLUDE_DIR arb.h)
    find_library(ARB_LIBRARY NAMES flint-arb arb)
    list(APPEND FLINT_required ARB_LIBRARY ARB_INCLUDE_DIR)
    if(NOT ARB_INCLUDE_DIR OR NOT ARB_LIBRARY)
      set(FLINT_trouble "FLINT ${FLINT_VERSION} is there, but not Arb, which is a library of its own \
before FLINT 3 (on Debian: libflint-arb-dev)")
    endif()
  else()
    # What an earlier search with FLINT 2 left in the cache would mix two Arbs.
    unset(ARB_INCLUDE_DIR CACHE)
    unset(ARB_LIBRARY CACHE)
    if(NOT EXISTS ${FLINT_INCLUDE_DIR}/flint/arb.h)
      set(FLINT_trouble "FLINT ${FLINT_VERSION} in ${FLINT_INCLUDE_DIR} lacks flint/arb.h")
    endif()
  endif()
endif()

include(FindPackageHandleStandardArgs)
if(FLINT_trouble)
  # One message that names the trouble, not the list of all variables.
  set(FLINT_usable FALSE)
  find_package_handle_standard_args(FLINT
    REQUIRED_VARS FLINT_usable REASON_FAILURE_MESSAGE "${FLINT_trouble}")
else()
  find_package_handle_standard_args(FLINT
    REQUIRED_VARS ${FLINT_required} VERSION_VAR FLINT_VERSION)
endif()
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_LIBRARY ARB_INCLUDE_DIR ARB_LIBRARY
  MPFR_INCLUDE_DIR MPFR_LIBRARY GMP_INCLUDE_DIR GMP_LIBRARY)

if(FLINT_FOUND AND NOT TARGET FLINT::FLINT)
  # Imported, so that its headers are system headers; in the order a static linker needs.
  set(FLINT_includes
    ${FLINT_INCLUDE_DIR} ${ARB_INCLUDE_DIR} ${MPFR_INCLUDE_DIR} ${GMP_INCLUDE_DIR})
  list(REMOVE_DUPLICATES FLINT_includes)
  set(FLINT_libraries ${ARB_LIBRARY} ${FLINT_LIBRARY} ${MPFR_LIBRARY} ${GMP_LIBRARY})
  add_library(FLINT::FLINT INTERFACE IMPORTED)
  set_target_properties(FLINT::FLINT PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${FLINT_includes}"
    INTERFACE_LINK_LIBRARIES "${FLINT_libraries}")
endif()
