#!/usr/bin/env bash
# environment.sh FOLDER REQUIREMENTS…: a virtual environment with what these files list, made once; the interpreter is
# PHRAME_PYTHON, or Debian's, or the first on the PATH. Without a network it is not made, and nothing is left. The
# versions are those tried, which need CPython 3.11; an older one takes what it can have.
set -euo pipefail
folder=$1
shift
wanted=$(sed -s 's/ *#.*//; /^$/d' "$@" | sort -u)
# More than is wanted may be there.
[[ ! -e $folder/made-of ]] || [[ -n $(comm -23 <(echo "$wanted") <(sort -u "$folder/made-of")) ]] || exit 0

python=${PHRAME_PYTHON:-/usr/bin/python3}
[[ -x $python ]] || python=$(command -v python3) || {
  echo 'Python 3 is not installed' >&2
  exit 1
}
rm -rf "$folder"
mkdir -p "$(dirname "$folder")"
echo "dev: making $folder, with packages from PyPI"
"$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))' || old=yes
mapfile -t packages < <(if [[ -n ${old:-} ]]; then sed 's/==.*//' <<<"$wanted"; else echo "$wanted"; fi)
if "$python" -m venv "$folder" &&
  "$folder/bin/python" -m pip install --quiet --disable-pip-version-check --no-compile --retries 5 "${packages[@]}"; then
  # Of all that is in them a third is ever imported: that is compiled now, since tests write nothing.
  env -u PYTHONDONTWRITEBYTECODE "$folder/bin/python" -c '
import importlib
for name in ("matplotlib.pyplot", "sympy", "numpy", "pytest", "hypothesis", "flint", "trimesh", "geomdl.NURBS", "distributed", "jsonschema"):
    try:
        importlib.import_module(name)
    except ImportError:
        pass' || true
  echo "$wanted" >"$folder/made-of"
else
  rm -rf "$folder"
  exit 1
fi
