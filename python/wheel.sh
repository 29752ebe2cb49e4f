#!/usr/bin/env bash
# wheel.sh [PYTHON…]: wheels for these interpreters, or for each CPython from 3.9 on that is found, in build/wheels. They
# carry FLINT and all else that is not Python's, NumPy's or every Linux's, with the licences. From 3.12 on there is one
# wheel, of the stable ABI. Each is tried by each interpreter, in a root where nothing else is.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=$PWD/build/wheel
wheels=$PWD/build/wheels
tools=$work/tools/bin
mkdir -p "$work" "$wheels"
quiet=(--quiet --disable-pip-version-check)
# One compiler for all: else that of each interpreter, and the library is compiled anew.
export CC=${CC:-cc} CXX=${CXX:-c++} PIP_ROOT_USER_ACTION=ignore

fail() {
  echo "wheel: $*" >&2
  exit 1
}

version() { "$1" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null; }

pythons=("$@")
if ((${#pythons[@]} == 0)); then
  for name in /usr/bin/python3 python3.{9..14}; do
    found=$(version "$name") || continue
    [[ " ${seen:-} " == *" $found "* ]] || pythons+=("$name")
    seen+=" $found"
  done
fi
python/environment.sh "$work/tools" python/wheel-requirements.txt || fail 'its tools cannot be had (see above)'

pip_of() { "$tools/python" -m pip --python "$@"; }  # PYTHON ARG…; none of its own is needed

build() {  # PYTHON; sets wheel
  local python=$1 raw=$work/raw
  rm -rf "$raw"
  # One folder for all interpreters: the library, which knows nothing of Python, is compiled once.
  pip_of "$python" wheel "${quiet[@]}" --no-deps --wheel-dir "$raw" --build-constraint python/build-constraints.txt \
    --config-settings=build-dir="$work/cmake" .
  rm -rf "$work/repaired"
  PATH=$tools:$PATH auditwheel repair --wheel-dir "$work/repaired" "$raw"/*.whl >"$work/repair.log" 2>&1 ||
    fail "$(cat "$work/repair.log")"
  "$tools/python" python/wheel_licences.py "$work/repaired"/*.whl
  wheel=$wheels/$(basename "$work/repaired"/*.whl)
  mv "$work/repaired"/*.whl "$wheel"
}

needed_by() {  # the shared libraries that these files are linked with
  ldd "$@" 2>/dev/null | sed -nE 's#.*(=> |\t)(/.+) \(0x[0-9a-f]+\)$#\2#p' | sort -u
}

# What is Python's own, and of libraries what that and NumPy are linked with.
fill_root() {  # PYTHON ROOT; sets inside, the interpreter's name there
  local python=$1 root=$2 standard platform
  inside=$("$python" -c 'import os, sys; print(os.path.realpath(sys.executable))')
  standard=$("$python" -c 'import sysconfig; print(sysconfig.get_path("stdlib"))')
  platform=$("$python" -c 'import sysconfig; print(sysconfig.get_path("platstdlib"))')
  (cd / && find ".$standard" ".$platform" \( -name site-packages -o -name dist-packages -o -name test -o -name 'config-3*' \
    -o -name '_tkinter*' -o -name '_dbm*' -o -name '_gdbm*' -o -name __pycache__ \) -prune -o -type f -print0) |
    tar -C / --null --files-from=- --dereference --create | tar -C "$root" --extract
  mapfile -t libraries < <(find "$root" -name '*.so*' -path '*lib-dynload*'; find "$root/try/numpy" -name '*.so*'; echo "$inside")
  mapfile -t libraries < <(needed_by "${libraries[@]}" | sed '\#/numpy\.libs/#d')
  cp -L --parents "$inside" "${libraries[@]}" "$root"
}

try() {  # PYTHON WHEEL
  local python=$1 root=$work/root inside libraries enter
  rm -rf "$root"
  mkdir -p "$root/try" "$root/tmp"
  pip_of "$python" install "${quiet[@]}" --prefer-binary --no-warn-conflicts --no-compile --target "$root/try" "$2" ||
    fail "$2 cannot be installed for $python"
  cp python/wheel_trial.py python/examples/quickstart.py "$root/try"
  fill_root "$python" "$root"
  if ((EUID == 0)); then enter=(chroot "$root"); else enter=(unshare --map-root-user --root="$root"); fi
  if "${enter[@]}" "$inside" -c pass; then
    "${enter[@]}" "$inside" -I -B /try/wheel_trial.py
  else
    echo "wheel: no root can be entered here: tried beside what is installed" >&2
    "$python" -I -B "$root/try/wheel_trial.py"
  fi
  rm -rf "$root"
}

rm -f "$wheels"/*.whl
stable=
for name in "${pythons[@]}"; do
  number=$(version "$name") || fail "not a Python: $name"
  python=$("$name" -c 'import sys; print(sys.executable)')  # pip takes no name
  echo "wheel: CPython $number"
  wheel=$stable
  [[ -n $wheel ]] || build "$python"
  [[ $wheel != *-abi3-* ]] || stable=$wheel
  try "$python" "$wheel"
done
ls -sh "$wheels"
