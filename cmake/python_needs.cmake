# pip shows what CMake says: here, at once, which of Debian's packages are missing, by what they bring. Included
# before project() it looks for the compiler only, without which nothing else can be looked for.
function(phrame_refuse)
  list(JOIN ARGN " " packages)
  message(FATAL_ERROR "To build the Python package, a compiler or libraries are missing. On Debian and Ubuntu:\n  \
apt-get install ${packages}\n(libflint-arb-dev only where there is one: FLINT 3 contains it.) \
Elsewhere: docs/dependencies.md.")
endfunction()

if(NOT PROJECT_NAME)
  separate_arguments(phrame_compiler UNIX_COMMAND "$ENV{CXX}")  # scikit-build-core: what Python was compiled with
  if(phrame_compiler)
    list(GET phrame_compiler 0 phrame_compiler)
  else()
    set(phrame_compiler c++ g++ clang++)
  endif()
  find_program(phrame_need_compiler NAMES ${phrame_compiler} NO_CACHE)
  if(NOT phrame_need_compiler)
    phrame_refuse(g++ python3-dev libflint-dev libflint-arb-dev libmpfr-dev libgmp-dev libboost-dev libfmt-dev
      libnlopt-dev nlohmann-json3-dev libeigen3-dev libcli11-dev)
  endif()
  return()
endif()

set(missing)
macro(phrame_python_needs package)
  find_path(phrame_need_${package} NAMES ${ARGN} PATH_SUFFIXES eigen3
    HINTS ${FLINT_ROOT}/include $ENV{FLINT_ROOT}/include NO_CACHE)
  if(NOT phrame_need_${package})
    list(APPEND missing ${package})
  endif()
endmacro()
phrame_python_needs(libflint-dev flint/flint.h)
phrame_python_needs(libflint-arb-dev arb.h flint/arb.h)  # FLINT 3 contains Arb
phrame_python_needs(libmpfr-dev mpfr.h)
phrame_python_needs(libgmp-dev gmp.h)
phrame_python_needs(libboost-dev boost/version.hpp)
phrame_python_needs(libfmt-dev fmt/format.h)
phrame_python_needs(libnlopt-dev nlopt.h)
phrame_python_needs(nlohmann-json3-dev nlohmann/json.hpp)
phrame_python_needs(libeigen3-dev Eigen/Core)
phrame_python_needs(libcli11-dev CLI/CLI.hpp)
if(Python_EXECUTABLE)
  execute_process(COMMAND ${Python_EXECUTABLE} -c "import sysconfig; print(sysconfig.get_path('include'))"
    OUTPUT_STRIP_TRAILING_WHITESPACE OUTPUT_VARIABLE phrame_python_include)
  if(NOT EXISTS "${phrame_python_include}/Python.h")
    list(APPEND missing python3-dev)
  endif()
endif()
if(missing)
  phrame_refuse(g++ ${missing})
endif()
