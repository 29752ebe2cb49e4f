#!/usr/bin/env bash
# test.sh BUILD: the tests of the Python package, as it was built in that folder; 77 where it was not.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=$1
python=$(sed -n 's/^Python_EXECUTABLE:[A-Z]*=//p' "$build/CMakeCache.txt")
module=$(echo "$build"/python/phrame/_phrame.*.so)
if [[ ! -e $module || ! -x $python ]]; then
  echo 'the Python package was not built'
  exit 77
fi
export PYTHONPATH=$build/python PYTHONDONTWRITEBYTECODE=1 PHRAME_PROGRAM=$build/bin/phrame
run_tests() { "$python" -m pytest -q -p no:cacheprovider "$@" python/tests; }
# What the sides of an assertion were is worth its time only where one fails: then it is told by running them again.
run_tests --assert=plain || {
  run_tests
  exit 1
}
rm -rf "$build/python-examples"
"$python" python/examples_of_documents.py "$build/python-examples"
"$python" -m mypy --strict --cache-dir "$build/mypy" "$build/python/phrame" python/examples "$build/python-examples"
