#!/usr/bin/env bash
# Runs a test in a network namespace of its own, where it can disturb nobody.
#   tests/in_namespace.sh loopback|isolated|lan COMMAND [ARGUMENT...]
# loopback: multicast passes on loopback. isolated: no interface is up, there is no route. lan: as
# isolated, and mounts are its own, too, so that it can make more namespaces (tests/lan/network.py).
# Exit status 77, which CTest counts as skipped, where the machine refuses such namespaces.
set -euo pipefail

kind=$1
shift
own=-rn
if [[ $kind == lan ]]; then own=-rnm; fi
if ! refusal=$(unshare $own true 2>&1); then
  echo "skipped: this machine refuses network namespaces to users (unshare $own: $refusal)"
  exit 77
fi
case $kind in
  loopback) exec unshare $own "$(dirname "$0")/../app/with_loopback_multicast.sh" "$@" ;;
  isolated | lan) exec unshare $own "$@" ;;
  *)
    echo "usage: $0 loopback|isolated|lan COMMAND [ARGUMENT...]" >&2
    exit 2
    ;;
esac
