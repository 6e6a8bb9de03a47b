#!/usr/bin/env bash
# Runs a test in a network namespace of its own, where it can disturb nobody.
#   tests/in_namespace.sh loopback|isolated COMMAND [ARGUMENT...]
# loopback: multicast passes on loopback. isolated: no interface is up, there is no route.
# Exit status 77, which CTest counts as skipped, where the machine refuses such namespaces.
set -euo pipefail

kind=$1
shift
if ! refusal=$(unshare -rn true 2>&1); then
  echo "skipped: this machine refuses network namespaces to users (unshare -rn: $refusal)"
  exit 77
fi
case $kind in
  loopback) exec unshare -rn "$(dirname "$0")/../app/with_loopback_multicast.sh" "$@" ;;
  isolated) exec unshare -rn "$@" ;;
  *)
    echo "usage: $0 loopback|isolated COMMAND [ARGUMENT...]" >&2
    exit 2
    ;;
esac
