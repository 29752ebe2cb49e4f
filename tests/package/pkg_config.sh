#!/bin/sh
# pkg_config.sh PREFIX LIBDIR COMPILER [FLAG…]: builds link.cpp, here, against what is installed in PREFIX, by
# phrame.pc, and runs it. 77 is "skipped".
set -eu
prefix=$1 libdir=$2 compiler=$3
shift 3
if ! command -v pkg-config >/dev/null; then
  echo 'pkg-config is not installed'
  exit 77
fi
export PKG_CONFIG_PATH="$prefix/$libdir/pkgconfig"
export LD_LIBRARY_PATH="$prefix/$libdir"  # of a shared one
options=$(pkg-config --cflags --libs phrame)  # quoted for a shell
eval '"$compiler" -std=c++20 "$@" "$(dirname "$0")/link.cpp" -o "$prefix/consumer"' "$options"
"$prefix/consumer"
