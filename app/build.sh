#!/usr/bin/env bash
# Installs what is missing, configures build/release and builds the given targets (all without any).
# Quiet unless something fails; ninja does only what changed sources need.
#   app/build.sh [--with test|plots|spy] [TARGET...]
set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
build=$root/build/release

sets=()
while [[ ${1-} == --with ]]; do
  sets+=("$2")
  shift 2
done

log=$build/build.log

# Says that it works when that takes more than a moment, and what went wrong when it fails.
quietly() {
  local what=$1 notice
  shift
  (sleep 2 >/dev/null 2>&1 && echo "build: $what; the first time takes some minutes (see $log)" >&2) 9>&- &
  notice=$!
  if ! "$@" >"$log" 2>&1; then
    kill "$notice" 2>/dev/null || true
    echo "build: $what failed:" >&2
    grep -v '^\[' "$log" | tail -n 60 >&2
    echo "build: all of it stands in $log" >&2
    exit 1
  fi
  kill "$notice" 2>/dev/null || true
}

mkdir -p "$build"
# Two that are started at the same time take turns.
exec 9>"$build/.lock"
flock 9

"$root/app/install.sh" "${sets[@]}"

# A Java compiler that has just come is found by configuring again.
if [[ ! -e $build/build.ninja || ! -e $build/lcm_types/gravity_wells_types.jar && " ${sets[*]} " == *" spy "* ]]; then
  quietly "configuring" cmake -S "$root" --preset release
fi
quietly "building" ninja -C "$build" "$@"
