#!/usr/bin/env bash
# The main job on a real curve: ./dev demo calls this with the program and the folder of examples.
set -euo pipefail
phrame=$1
examples=$2
cd "$(dirname "${BASH_SOURCE[0]}")"
curve=curves/farouki-2003-quintic.json

show() {
  echo
  echo "\$ phrame $*"
  "$phrame" "$@"
}

show angle "$curve" --at 0,1/2,1 --digits 50
show angle "$curve" --frame frenet --at 0,1/2,1 --digits 50
show info "$curve"
show frames "$curve" --samples 3
echo
"$examples/farouki_2003"
