#!/bin/sh
# embedded.sh FOLDER COMPILER: a project that is strict with itself, and that has phrame by add_subdirectory, sees no
# warnings of phrame's sources, nor of its headers.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$1 compiler=$2
rm -rf "$work"
mkdir -p "$work"
cat >"$work/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(strict CXX)
set(CMAKE_CXX_FLAGS "-Wall -Wpadded -Weffc++ -Werror")
add_compile_options(-Wextra)
add_subdirectory("$root" phrame)
add_library(strict OBJECT main.cpp)
target_link_libraries(strict PRIVATE phrame::phrame)
END
echo '#include "phrame/algebra/error.hpp"' >"$work/main.cpp"
cmake -G Ninja -S "$work" -B "$work/build" -D CMAKE_CXX_COMPILER="$compiler" -D PHRAME_UNITY=OFF >"$work/log"
ninja -C "$work/build" --quiet CMakeFiles/strict.dir/main.cpp.o phrame/CMakeFiles/phrame.dir/src/algebra/progress.cpp.o
