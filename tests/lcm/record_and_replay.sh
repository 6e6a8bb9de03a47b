#!/usr/bin/env bash
# lcm-logger records live traffic, every type of ours is decoded from its log, and lcm-logplayer
# plays the log to a receiver that hears the same bytes. Run it in a network namespace.
#   record_and_replay.sh LCM_TOOLS_FOLDER EVERY_TYPE PYTHON LCM_GEN TYPES_FOLDER
set -euo pipefail

tools=$1 every_type=$2 python=$3 lcm_gen=$4 types=$5
folder=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; rm -rf "$folder"' EXIT
export LCM_DEFAULT_URL="udpm://239.255.76.67:9231?ttl=0"

"$tools/lcm-logger" --quiet "$folder/log" &
logger=$!
"$every_type" publish 2
# Interrupted, as a user does it: it writes what it still holds.
kill -INT "$logger"
wait "$logger" || true
"$python" "$(dirname "$0")/decode_log.py" "$lcm_gen" "$types" "$folder/log"

"$every_type" await 20 &
receiver=$!
for _ in 1 2 3 4 5; do
  kill -0 "$receiver" 2>/dev/null || break
  "$tools/lcm-logplayer" "$folder/log"
done
wait "$receiver"
