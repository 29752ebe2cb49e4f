#!/usr/bin/env bash
# fresh.sh [--only STAGE,…] [--ccache] [SUITE…]: does what README.md says, and what is installed after that, on Debian
# systems that have just been made: as root and as a visitor who has no sudo, from folders with a blank in their names,
# with LC_ALL=C and umask 077. ./dev fresh calls this as root. What is tried is the last commit.
#
# The stages: demo, test (once where npm is blocked, once without a pseudo-terminal), wheel, products (what is
# installed and packaged); and, not by default, prove (by the Coq of that release). --ccache installs ccache there, and keeps what was compiled in build/fresh/ccache-SUITE.
#
# A system is in build/fresh/SUITE, the output of each step beside it; packages are kept in build/fresh/debs for the
# next time. The mirror is the host's, or Debian's, or what PHRAME_MIRROR says.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# However this ends, all that runs in the systems and all that is mounted there ends with it.
if [[ ${1:-} != --inside ]]; then
  exec unshare --mount --pid --fork --kill-child bash tests/fresh.sh --inside "$@"
fi
trap 'exit 130' INT TERM
umask 022
shift

stages=demo,test,wheel,products
with_ccache=false
suites=()
while (($#)); do
  case $1 in
    --only) stages=${2:?--only: a stage is needed} && shift ;;
    --ccache) with_ccache=true ;;
    *) suites+=("$1") ;;
  esac
  shift
done
for stage in ${stages//,/ }; do
  [[ $stage =~ ^(demo|test|wheel|products|prove)$ ]] || {
    echo "fresh: not a stage: $stage" >&2
    exit 1
  }
done
((${#suites[@]})) || suites=(bookworm trixie)
for suite in "${suites[@]}"; do
  [[ -e /usr/share/debootstrap/scripts/$suite ]] || {
    echo "fresh: debootstrap does not know this suite: $suite" >&2
    exit 1
  }
done
if [[ -n $(git status --porcelain) ]]; then
  echo 'fresh: what has not been committed is not tried'
fi

work=$PWD/build/fresh
mkdir -p "$work/debs"
mirror=${PHRAME_MIRROR:-}
if [[ -z $mirror ]]; then
  mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' 'Label: Debian')
  mirror=${mirror%%$'\n'*}
fi
mirror=${mirror:-http://deb.debian.org/debian}

# ---- systems

make_system() {  # SUITE
  local root=$work/$1
  rm -rf --one-file-system "$root" "$root-clean"
  debootstrap --variant=minbase --cache-dir="$work/debs" "$1" "$root" "$mirror"
  printf 'deb %s main\n' "$mirror $1" "$mirror $1-updates" "${mirror/%debian/debian-security} $1-security" \
    >"$root/etc/apt/sources.list"
  # Proxies and the like are the host's, as are, by debootstrap, its name servers.
  apt-config dump --format '%F "%v";%n' Acquire::http Acquire::https Acquire::ftp Acquire::Retries \
    Acquire::Check-Valid-Until Acquire::Check-Date >"$root/etc/apt/apt.conf.d/host"
  [[ ! -e ${NODE_EXTRA_CA_CERTS:-} ]] || install -m 644 "$NODE_EXTRA_CA_CERTS" "$root/etc/host.crt"
  chroot "$root" useradd --create-home visitor
  mount_system "$root"
  in_system "$root" root / apt-get update
  cp -a --one-file-system "$root" "$root-clean"
  if $with_ccache; then
    in_system "$root" root / apt-get install -y -qq --no-install-recommends ccache
    mkdir -p "$work/ccache-$1" "$root/ccache"
    mount --bind "$work/ccache-$1" "$root/ccache"
    chmod 1777 "$root/ccache"
  fi
  mount_system "$root-clean"
  clone "$root" root
  clone "$root" visitor
}

mount_system() {  # ROOT
  mount -t proc proc "$1/proc"
  mount --rbind /dev "$1/dev"
  mount --bind "$work/debs" "$1/var/cache/apt/archives"
}

home_of() { if [[ $1 == root ]]; then echo /root; else echo "/home/$1"; fi; }

clone() {  # ROOT USER
  local folder
  folder="$1$(home_of "$2")/my work"
  (umask 077 && git clone --quiet --no-hardlinks . "$folder/phrame")
  chroot "$1" chown -R "$2:$2" "$(home_of "$2")/my work"
}

in_system() {  # ROOT USER FOLDER COMMAND…
  local root=$1 user=$2 folder=$3 name keep=()
  for name in http_proxy https_proxy ftp_proxy no_proxy HTTP_PROXY HTTPS_PROXY FTP_PROXY NO_PROXY; do
    [[ -z ${!name:-} ]] || keep+=("$name=${!name}")
  done
  # A company's own certificates, too.
  [[ ! -e $root/etc/host.crt ]] || keep+=(NODE_EXTRA_CA_CERTS=/etc/host.crt PIP_CERT=/etc/host.crt)
  chroot --userspec="$user:$user" "$root" /usr/bin/env -i \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME="$(home_of "$user")" \
    USER="$user" TERM=dumb LC_ALL=C "${keep[@]}" \
    CCACHE_DIR=/ccache CCACHE_UMASK=000 CCACHE_NOHASHDIR=1 CCACHE_BASEDIR="$(home_of "$user")" \
    bash -c 'umask 077 && cd "$1" && "${@:2}"' bash "$folder" "${@:4}" </dev/null
}

in_clone() { in_system "$work/$suite" "$1" "$(home_of "$1")/my work/phrame" "${@:2}"; }  # USER COMMAND…

# ---- steps

summary=()
failed=0

step() {  # NAME COMMAND…; its output goes to the file $log
  local start=$SECONDS result=ok
  log=$work/$suite.${1//[^a-z0-9]/-}.log
  echo "fresh: $suite: $1 …"
  # In a shell of its own, where the first failure is the last command: `if` would let it go on.
  set +e
  (
    set -e
    "${@:2}"
  ) >"$log" 2>&1
  (($? == 0)) || result=FAILED
  set -e
  if [[ $result == FAILED ]]; then
    failed=1
    tail -n 40 "$log" | sed 's/^/    /'
    echo "fresh: all of it is in $log"
  fi
  summary+=("$(printf '%-10s %-52s %-6s %5d s' "$suite" "$1" "$result" $((SECONDS - start)))")
}

missing_are_named() {
  local status=0 output named
  output=$(in_clone visitor ./dev demo 2>&1) || status=$?
  echo "$output"
  [[ $status == 1 && $output =~ 'apt-get install --no-install-recommends '([^$'\n']*) ]]
  named=${BASH_REMATCH[1]}
  [[ " $named " == *' libflint-dev '* ]]
  echo "$named" >"$work/$suite.named"
}

root_demo() {
  in_clone root ./dev demo | tee "$work/$suite.shown"
  is_shown <"$work/$suite.shown"
  # What the visitor was told is what root needed; it is not much, and apt-get is not heard.
  local shown
  shown=$(<"$work/$suite.shown")
  [[ $shown =~ 'dev: installing '([^$'\n']*) ]]
  [[ ${BASH_REMATCH[1]} == "$(<"$work/$suite.named")" ]]
  [[ $shown != *Unpacking* && ! -e $work/$suite/usr/bin/npm ]]
}

has_page() {  # USER; does the program that was built there write a page?
  in_clone "$1" build/dev/bin/phrame page examples/curves/farouki-2003-quintic.json -o build/page.html
}

not_run() {  # the tests that ./dev test names in the file of what was shown
  sed -n 's/^dev: .* tests ran\. Not run: \(.*\) (what they need.*/\1/p' "$work/$suite.shown"
}

test_without_npm() {
  in_clone root env CI=true npm_config_registry=http://127.0.0.1:9/ ./dev test --page | tee "$work/$suite.shown"
  [[ " $(not_run) " == *' io.write.page '* ]]
  [[ $(<"$work/$suite.shown") == *'pages and meshes were not looked at'* ]]
  if has_page root; then return 1; fi
}

test_with_page() {
  in_clone root env CI=true ./dev test --page | tee "$work/$suite.shown"
  [[ $(not_run) == 'peers_clipper peers_maxima' ]]
  [[ $(<"$work/$suite.shown") != *'were not looked at'* ]]
  has_page root
}

test_without_terminal() {
  local status=0
  mount -t tmpfs none "$work/$suite/dev/pts"
  in_clone visitor env CI=true ./dev test | tee "$work/$suite.shown" || status=$?
  umount "$work/$suite/dev/pts"
  [[ $status == 0 && $(not_run) == 'cli.progress peers_clipper peers_maxima' ]]
}

is_shown() {  # θ(1/2) of the README's curve, from its page
  [[ $(cat) == *0.13516216082994722857811002656592103800989118578632* ]]
}

visitor_demo() {
  in_clone visitor ./dev demo | tee "$work/$suite.shown"
  is_shown <"$work/$suite.shown"
}

run_installed() {  # ROOT PROGRAM CURVE
  in_system "$1" visitor / "$2" angle "$3" --at 1/2 --digits 50 | tee "$work/$suite.shown"
  is_shown <"$work/$suite.shown"
}

install_and_run() {
  local prefix='/opt/phrame of root'
  in_clone root ./dev install "$prefix"
  run_installed "$work/$suite" "$prefix/bin/phrame" \
    "$prefix/share/doc/phrame/examples/curves/farouki-2003-quintic.json"
  in_clone root ./dev uninstall "$prefix"
  [[ ! -e $work/$suite$prefix ]]
}

use_wheel() {  # where there is Python, and nothing of what the wheel was made with
  local root=$work/$suite-clean
  in_system "$root" root / env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends python3-venv
  mkdir -p "$root/tmp/wheel"
  cp "$work/$suite"/root/'my work'/phrame/build/wheels/*.whl python/wheel_trial.py python/examples/quickstart.py "$root/tmp/wheel"
  chmod -R a+rX "$root/tmp/wheel"
  in_system "$root" visitor /home/visitor bash -eo pipefail -c '
    python3 -m venv environment
    environment/bin/pip install --quiet /tmp/wheel/*.whl
    environment/bin/python -I -B /tmp/wheel/wheel_trial.py'
}

install_package() {  # ROOT; as root would who was given the file
  cp "$work/$suite"/root/'my work'/phrame/build/package/*.deb "$1/tmp/phrame.deb"
  chmod 644 "$1/tmp/phrame.deb"
  in_system "$1" root /tmp env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq ./phrame.deb
  run_installed "$1" phrame /usr/share/doc/phrame/examples/curves/farouki-2003-quintic.json
}

use_package() {  # where nothing but the package and what it depends on and recommends is there
  install_package "$work/$suite-clean"
  in_system "$work/$suite-clean" root / env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq man-db
  in_system "$work/$suite-clean" visitor /home/visitor bash -eo pipefail -c '
    [[ $(man phrame-angle) == *--start-normal* ]]
    source /usr/share/bash-completion/completions/phrame
    COMP_WORDS=(phrame ang) COMP_CWORD=1
    _phrame
    [[ ${COMPREPLY[*]} == angle ]]
    [[ $(</usr/share/doc/phrame/copyright) == *"the phrame authors"* ]]
    phrame page /usr/share/doc/phrame/examples/curves/farouki-2003-quintic.json -o page.html
    phrame certify /usr/share/doc/phrame/examples/curves/farouki-2003-quintic.json --at 1 -o one.cert
    python3 /usr/share/phrame/check_certificate.py -q one.cert'
}

use_library() {  # where the packages for compiling are there
  install_package "$work/$suite"
  in_clone visitor bash -eo pipefail -c '
    mkdir "../a user of it"
    cp tests/package/* "../a user of it"
    cd "../a user of it"
    cmake -G Ninja -S . -B build
    cmake --build build
    build/consumer
    eval g++ -std=c++20 main.cpp -o consumer "$(pkg-config --cflags --libs phrame)"
    ./consumer'
}

clones_are_clean() {
  local user changed
  for user in root visitor; do
    changed=$(git -c safe.directory='*' -C "$work/$suite$(home_of $user)/my work/phrame" status --porcelain)
    echo "$changed"
    [[ -z $changed ]]
  done
}

demo_stage() {
  step 'visitor: ./dev demo says what root must install' missing_are_named
  step 'root: ./dev demo' root_demo
  step 'visitor: ./dev demo' visitor_demo
}

test_stage() {
  step 'root: ./dev test --page where npm is blocked' test_without_npm
  step 'root: ./dev test --page' test_with_page
  step 'visitor: ./dev test without a pseudo-terminal' test_without_terminal
}

wheel_stage() {
  step 'root: ./dev wheel' in_clone root ./dev wheel
  step 'visitor: the wheel where only Python is' use_wheel
}

products_stage() {
  step 'root: ./dev figures' in_clone root ./dev figures
  step 'root: ./dev package' in_clone root ./dev package
  step 'root: ./dev install, run by the visitor, uninstall' install_and_run
  step 'the package where nothing else is' use_package
  step 'the package in programs of the visitor' use_library
}

prove_stage() {
  step 'root: ./dev prove' in_clone root ./dev prove
}

for suite in "${suites[@]}"; do
  step 'a fresh system' make_system "$suite"
  for stage in ${stages//,/ }; do "${stage}_stage"; done
  step 'no file of git has changed' clones_are_clean
done

echo
printf '%s\n' "${summary[@]}"
if ((failed)); then
  echo 'fresh: not all is well'
  exit 1
fi
for suite in "${suites[@]}"; do
  for root in "$work/$suite" "$work/$suite-clean"; do
    umount -lR "$root/proc" "$root/dev" "$root/var/cache/apt/archives"
    if mountpoint -q "$root/ccache"; then umount "$root/ccache"; fi
    rm -rf --one-file-system "$root"
  done
done
echo 'fresh: all is well'
