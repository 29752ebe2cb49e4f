#!/bin/sh
# with_python.sh SCRIPT [ARG…]: runs it by PHRAME_PYTHON, where that is set, or Debian's Python, which has Debian's SymPy.
# It is looked for when a test runs, not when CMake does, so that a test is there however late Python comes; 77 is
# "skipped". What tests have in common is in support/.
PYTHONPATH=$(dirname "$0")/support
export PYTHONPATH
for python in ${PHRAME_PYTHON:+"$PHRAME_PYTHON"} /usr/bin/python3 python3; do
  if command -v "$python" >/dev/null; then exec "$python" -B "$@"; fi
done
echo 'Python 3 is not installed'
exit 77
