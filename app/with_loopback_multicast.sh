#!/usr/bin/env bash
# Runs a command with multicast on loopback, for a network namespace of its own:
#   unshare -rn app/with_loopback_multicast.sh COMMAND [ARGUMENT...]
# so that the command can multicast without touching any real network.
set -euo pipefail

if (($# == 0)); then
  echo "usage: unshare -rn $0 COMMAND [ARGUMENT...]" >&2
  exit 2
fi
# A namespace that was just made has loopback only, and it is down.
if ip -o link show up | grep -q .; then
  echo "$0: this network namespace is in use; start it with unshare -rn" >&2
  exit 2
fi
ip link set lo up multicast on
ip route add 224.0.0.0/4 dev lo
exec "$@"
