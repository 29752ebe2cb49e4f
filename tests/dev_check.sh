#!/usr/bin/env bash
# What ./dev decides: which packages it installs, and what it says of tests that did not run. A copy of it
# is run, with stand-ins for the programs that it calls.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "failed: $*" >&2
  exit 1
}

mkdir "$work/bin" "$work/tree"
cp dev "$work/tree"
ln -s "$root"/{tests,examples,CMakePresets.json} "$work/tree"

stand_in() {  # NAME SCRIPT
  printf '#!/usr/bin/env bash\n%s\n' "$2" >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}

dev() {  # VARIABLE=VALUE… COMMAND; sets status and output
  status=0
  output=$(cd "$work" && env PATH="$work/bin:$PATH" work="$work" "${@:1:$#-1}" tree/dev ${!#} 2>&1) || status=$?
}

stand_in sudo 'exec "$@"'
stand_in dpkg-query 'exit 1'  # nothing is installed
stand_in dpkg 'exit 1'
stand_in apt-get 'echo "$*" >>"$work/apt-get.log"; echo Unpacking; [[ ! -e $work/apt-fails ]] || exit 100'
stand_in apt-cache '
[[ $LC_ALL == C ]] || { echo "Installationskandidat: 1.0"; exit; }
echo "$2:"
echo "  Candidate: 1.0"
for ((k = 0; k < 20000; ++k)); do echo "  500 http://example.org stable/main amd64 Packages"; done'
stand_in cmake 'mkdir -p build/dev && touch build/dev/build.ninja && exit 7'

# apt-cache goes on writing after the line that matters, and a pipe would be closed by then.
dev DEV_YES=1 LC_ALL= LANG=de_DE.UTF-8 demo
[[ $status == 7 ]] || fail "a failure of cmake is one of ./dev: $status, $output"
[[ " $(cat "$work/apt-get.log") " == *' libflint-arb-dev '* ]] || fail "Arb is not installed: $output"
[[ $output == *'dev: installing '*' libflint-dev '* ]] || fail "it is not said what is installed: $output"

# The demo asks for nothing of the page's, and apt-get's own words are shown where it fails.
[[ " $(cat "$work/apt-get.log") " != *' npm '* ]] || fail 'the demo installs npm'
[[ $output != *Unpacking* && $(<"$work/tree/build/apt-get.log") == Unpacking ]] || fail "apt-get is heard: $output"
touch "$work/apt-fails"
dev DEV_YES=1 demo
[[ $status == 1 && $output == *Unpacking* && $output == *'dev: failed: '*apt-get* ]] || fail "a failure of apt-get: $output"
rm "$work/apt-fails"

stand_in apt-cache 'exit 0'  # which does not know Arb, as in Debian 13
rm "$work/apt-get.log"
dev DEV_YES=1 demo
[[ " $(cat "$work/apt-get.log") " != *' libflint-arb-dev '* ]] || fail 'Arb is installed where there is none'

# The steps are those of the plan, and the tests that ran those of the report.
stand_in cmake 'mkdir -p build/dev && touch build/dev/build.ninja'
stand_in ninja 'echo "[40/40] Linking"'
stand_in nproc 'exit 127'  # which macOS does not have
stand_in ctest '
report=${*: -1}
while read -r name; do
  echo "	<testcase name=\"$name\" classname=\"$name\" time=\"0.5\" status=\"run\">"
done <"$work/ran" >"$report"
echo "	<testcase name=\"batch\" classname=\"batch\" time=\"0\" status=\"notrun\">" >>"$report"'
: >"$work/ran"
dev DEV_YES=1 CI= test
[[ $status == 0 && $output =~ 'dev: 40 steps, about '[0-9]+' min' ]] || fail "$output"
[[ $output =~ 'dev: 0 of '([0-9]+)' tests ran. Not run: '([a-z0-9_. ]*) ]] || fail "$output"
all=(${BASH_REMATCH[2]})
((${#all[@]} == BASH_REMATCH[1])) || fail "a number of tests, and other tests: $output"
for name in algebra.roots ph.along.rmf_angle batch certificates cli.mtf dev example_quickstart package peers_sympy pkg_config; do
  [[ " ${all[*]} " == *" $name "* ]] || fail "$name would not be missed"
done

ran_all_but() { printf '%s\n' "${all[@]}" | sed "/^$1\$/d" >"$work/ran"; }
ran_all_but none
dev CI=true DEV_YES=1 test
[[ $status == 0 && $output == *"dev: all ${#all[@]} tests ran"* ]] || fail "$output"
ran_all_but peers_maxima
dev CI=true DEV_YES=1 test
[[ $status == 0 && $output == *'Not run: peers_maxima '* ]] || fail "Maxima is not asked for: $output"
dev CI=true DEV_YES=1 'test --peers'
[[ $status == 1 && $output == *'none may be left out'* ]] || fail "Maxima is asked for: $output"
ran_all_but none
echo ph.new_room.stranger >>"$work/ran"
dev CI= DEV_YES=1 test
[[ $status == 1 && $output == *'the list of those to be expected lacks: ph.new_room.stranger'* ]] ||
  fail "a test that is not expected: $output"
ran_all_but batch
dev CI= DEV_YES=1 test
[[ $status == 0 && $output == *'Not run: batch '* ]] || fail "$output"
dev CI=true DEV_YES=1 test
[[ $status == 1 ]] || fail "a test is missing, and CI is content: $output"

# What was installed goes, with the folders that it alone needed; what others put there stays.
mkdir -p "$work/prefix/"{bin,lib/cmake/phrame,share/phrame}
touch "$work/prefix/"{bin/phrame,bin/other,lib/cmake/phrame/phrameConfig.cmake}
printf "$work/prefix/%s\n" bin/phrame lib/cmake/phrame/phrameConfig.cmake >"$work/prefix/share/phrame/installed.txt"
dev 'uninstall prefix'
[[ $status == 0 && $(cd "$work/prefix" && find . | sort | tr '\n' ' ') == '. ./bin ./bin/other ' ]] ||
  fail "uninstall: $output $(find "$work/prefix")"
dev 'uninstall prefix'
[[ $status == 1 && $output == *'no phrame is there'* ]] || fail "uninstall: $output"

# A source that is gone since the last build is no reason to stop: here of another, small project.
rm "$work"/bin/{cmake,ninja} "$work/tree/build" -r
cat >"$work/tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(small NONE)
file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/*.txt)
add_custom_command(OUTPUT list COMMAND ${CMAKE_COMMAND} -E echo listed ${sources} DEPENDS ${sources})
add_custom_target(phrame_program DEPENDS list)
add_custom_target(example_farouki_2003)
END
touch "$work/tree"/{one,other}.txt
dev DEV_YES=1 demo
[[ $output == *'listed '*/other.txt* ]] || fail "the small project is not built: $output"
rm "$work/tree/other.txt"
dev DEV_YES=1 demo
[[ $output == *'listed '*/one.txt* && $output != *other.txt* ]] || fail "a source that is gone is asked for: $output"

# A page that could not be bundled, for want of a network, comes with the next build that has one; what has been
# bundled is not bundled again.
page=$work/page
mkdir -p "$page/page/src"
ln -s "$root/cmake" "$page/cmake"
touch "$page"/page/{package.json,package-lock.json,build.mjs,src/main.js}
cat >"$page/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(small NONE)
include(cmake/page.cmake)
add_custom_target(small ALL)
phrame_page(small)
END
stand_in npm 'echo npm >>"$work/page/calls"; [[ -e $work/network ]] || { echo "no network" >&2; exit 1; }'
stand_in node 'echo node >>"$work/page/calls"; echo bundled >"$2"'
bundle() { output=$(env PATH="$work/bin:$PATH" work="$work" cmake --build "$page/build" 2>&1) || fail "$output"; }
cmake -G Ninja -S "$page" -B "$page/build" >/dev/null
for _ in 1 2; do
  bundle
  [[ $output == *'phrame page will not be there: npm: no network'* ]] || fail "it is not said that there is no page: $output"
  [[ $(<"$page/build/page/page_template.cpp") == *'pieces;'* ]] || fail 'no source where there is no page'
done
touch "$work/network"
for _ in 1 2 3; do
  bundle
  [[ $(<"$page/build/page/page_template.cpp") == bundled ]] || fail "there is a network, and no page: $output"
done
[[ $(tr '\n' ' ' <"$page/calls") == 'npm npm npm node ' ]] || fail "called: $(<"$page/calls")"
echo changed >"$page/page/src/main.js"
bundle
[[ $(tr '\n' ' ' <"$page/calls") == 'npm npm npm node node ' ]] || fail "called: $(<"$page/calls")"

# The same trap elsewhere.
if grep -nE '\| *(grep -[a-zA-Z]*[qm]|head)' dev .ci/run {bench,examples,tests}/*.sh {bench,tests}/*/*.sh 2>/dev/null |
  sed '/^tests\/dev_check/d' | grep .; then
  fail 'a pipe into what goes before it has read all'
fi
