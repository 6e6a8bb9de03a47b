#!/usr/bin/env bash
# Installs what is missing on Debian 12: packages with apt-get, and LCM 1.5.3 into .venv where the
# system has no LCM of at least 1.5. When nothing is missing it takes milliseconds.
#   app/install.sh [test] [plots] [spy]
# With no argument what the program needs; "test" adds what only the tests need, "plots" a gnuplot,
# "spy" a Java.
set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
lcm_version=1.5.3

# package - why
build_packages="
g++ - compiles the program
cmake - configures the build
ninja-build - builds
pkg-config - finds libraries
libbullet-dev - Bullet: broadphase, and the stock baseline
libosmesa6-dev - OSMesa: renders without a screen
libeigen3-dev - vectors and matrices
libhwy-dev - Highway: vector instructions of several processors in one program
libcli11-dev - options
libfmt-dev - formatted text
nlohmann-json3-dev - reports
libpng-dev - frames
libfreetype-dev - the legend's text
fonts-dejavu-core - the legend's font
ffmpeg - frames to MP4
libglib2.0-0 - LCM runs on it
iproute2 - a network of the demonstration's own
ca-certificates - fetching LCM over https
python3-venv - holds LCM
libgtest-dev - GoogleTest: the tests are part of the build's configuration
libbenchmark-dev - Google Benchmark: so are the micro-benchmarks
"
test_packages="
clang-format - checks the format of the sources
nftables - loses datagrams between peers
"
plots_packages="
gnuplot-nox - draws the plots of the benchmark
"
spy_packages="
openjdk-17-jre - runs lcm-spy's window
openjdk-17-jdk-headless - compiles our message types for it
"

say() { echo "install: $*" >&2; }

# Packages of a table that are not installed.
missing_of() {
  local wanted
  wanted=$(sed -n 's/ - .*//p' <<<"$1")
  # shellcheck disable=SC2086  # one word a package
  comm -23 <(sort <<<"$wanted") \
    <(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null |
      sed -n 's/^installed //p' | sort -u)
}

as_root() {
  if ((EUID == 0)); then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    say "root is needed and there is no sudo; run as root: $*"
    exit 1
  fi
}

# Quiet when it works; everything it said when it does not.
quietly() {
  local said
  if ! said=$("$@" 2>&1); then
    say "this failed: $*"
    echo "$said" >&2
    exit 1
  fi
}

install_packages() {
  local table=$1 missing package
  if ! command -v dpkg-query >/dev/null; then
    say "this is no Debian; please see to these yourself:"
    echo "$table" >&2
    return
  fi
  missing=$(missing_of "$table")
  [[ -n $missing ]] || return 0
  say "these packages are missing and will be installed with apt-get:"
  for package in $missing; do
    say "  $(grep "^$package - " <<<"$table")"
  done
  quietly as_root apt-get -o DPkg::Lock::Timeout=300 update
  # shellcheck disable=SC2086  # one word a package
  quietly as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 \
    install --yes --no-install-recommends $missing
}

system_has_lcm() {
  compgen -G "/usr/lib/*/lcm/cmake/lcmConfig.cmake" >/dev/null ||
    compgen -G "/usr/local/lib*/lcm/cmake/lcmConfig.cmake" >/dev/null || return 1
  pkg-config --atleast-version=1.5 lcm 2>/dev/null && command -v lcm-gen >/dev/null
}

venv_has_lcm() {
  compgen -G "$root/.venv/lib/python3*/site-packages/lcm-$lcm_version.dist-info/RECORD" >/dev/null
}

install_lcm() {
  if system_has_lcm || venv_has_lcm; then return; fi
  say "the system has no LCM >= 1.5 (Debian 12 has 1.3.1); lcm $lcm_version from PyPI goes into .venv"
  # Debian's own Python: another one on the PATH may come without the venv module.
  quietly /usr/bin/python3 -m venv --clear "$root/.venv"
  quietly "$root/.venv/bin/python3" -m pip install --quiet "lcm==$lcm_version"
}

# A Java that can open windows, and a compiler, wherever they come from.
has_java() {
  local java
  java=$(readlink -f "$(command -v java)") && command -v javac >/dev/null &&
    [[ -e $(dirname "$java")/../lib/libawt_xawt.so ]]
}

# Debian has several gnuplots that exclude each other; any of them will do.
has_gnuplot() { command -v gnuplot >/dev/null; }

packages=$build_packages
for set in "$@"; do
  case $set in
    test)
      packages+=$test_packages
      has_gnuplot || packages+=$plots_packages
      ;;
    plots) has_gnuplot || packages+=$plots_packages ;;
    spy) has_java || packages+=$spy_packages ;;
    *)
      echo "usage: $0 [test] [plots] [spy]" >&2
      exit 2
      ;;
  esac
done
install_packages "$packages"
install_lcm
