#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test. Arguments go to ctest.
set -euo pipefail

root=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
"$root/app/build.sh" --with test
exec ctest --test-dir "$root/build/release" --output-on-failure -j "$(nproc)" "$@"
