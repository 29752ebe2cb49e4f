#!/usr/bin/env bash
# environment.sh FOLDER: a virtual environment with what python/requirements.txt lists, made once; the
# interpreter is PHRAME_PYTHON, or Debian's, or the first on the PATH. Without a network it is not made, and
# nothing is left.
set -euo pipefail
folder=$1
requirements=$(dirname "${BASH_SOURCE[0]}")/requirements.txt
! cmp -s "$requirements" "$folder/made-of" || exit 0

python=${PHRAME_PYTHON:-/usr/bin/python3}
[[ -x $python ]] || python=$(command -v python3) || {
  echo 'Python 3 is not installed' >&2
  exit 1
}
rm -rf "$folder"
mkdir -p "$(dirname "$folder")"
echo "dev: making $folder, with packages from PyPI"
if "$python" -m venv "$folder" &&
  "$folder/bin/python" -m pip install --quiet --disable-pip-version-check --retries 5 -r "$requirements"; then
  cp "$requirements" "$folder/made-of"
else
  rm -rf "$folder"
  exit 1
fi
