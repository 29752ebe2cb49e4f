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
"$python" -m pytest -q -p no:cacheprovider python/tests
rm -rf "$build/python-examples"
"$python" python/examples_of_documents.py "$build/python-examples"
"$python" -m mypy --strict --cache-dir "$build/mypy" "$build/python/phrame" python/examples "$build/python-examples"
