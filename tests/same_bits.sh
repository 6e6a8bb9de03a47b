#!/usr/bin/env bash
# Does a world have the same bits however the program was built and runs? Builds it with and without
# optimisation, for any x86-64 and for this processor alone, runs scene T1 with each build, each
# instruction set that the processor has and several numbers of threads, and prints the hashes of
# the states at the end. Exit status 1 when they are not all one. A full run takes a long while, most
# of it without optimisation.
#   tests/same_bits.sh [--balls N] [--steps N] [--threads "1 2 4"] [--program FILE]
# T1 has 10,000 balls and takes 300 steps unless told. With --program: only that one, as it was built.
set -euo pipefail

root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
balls=10000
steps=300
threads="1 2 4"
program=
while (($#)); do
  case $1 in
    --balls) balls=$2 ;;
    --steps) steps=$2 ;;
    --threads) threads=$2 ;;
    --program) program=$2 ;;
    *) sed -n '2,/^set/{/^#/p}' "$0" >&2; exit 2 ;;
  esac
  shift 2
done

hashes=$(mktemp)
trap 'rm -f "$hashes"' EXIT

# row BUILD PROGRAM INSTRUCTIONS
row() {
  local build=$1 file=$2 set=$3 count hash
  for count in $threads; do
    hash=$("$file" bench --scene T1 --balls "$balls" --steps "$steps" --no-books --threads "$count" \
             --instructions "$set" |
           python3 -c 'import csv, sys; print(next(csv.DictReader(sys.stdin))["state_hash"])')
    printf '%-14s %-9s %7s  %s\n' "$build" "$set" "$count" "$hash"
    echo "$hash" >>"$hashes"
  done
}

# sets BUILD PROGRAM: a row for each instruction set of this processor.
sets() {
  local set
  for set in baseline avx2 avx512; do
    if "$2" bench --instructions "$set" --list >/dev/null 2>&1; then
      row "$1" "$2" "$set"
    else
      printf '%-14s %-9s not in this processor\n' "$1" "$set"
    fi
  done
}

# built NAME BUILD_TYPE NATIVE: the program, built in build/NAME.
built() {
  local folder=$root/build/$1
  mkdir -p "$folder"
  if ! { cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE="$2" -DWELLS_NATIVE="$3" &&
         ninja -C "$folder" gravity-wells; } >"$folder/build.log" 2>&1; then
    tail -n 40 "$folder/build.log" >&2
    exit 1
  fi
  echo "$folder/gravity-wells"
}

echo "T1, $balls balls, $steps steps"
printf '%-14s %-9s %7s  %s\n' build vectors threads "state hash"
if [[ -n $program ]]; then
  sets given "$program"
else
  sets "-O3" "$(built release Release OFF)"
  sets "-O3 native" "$(built native Release ON)"
  sets "-O0" "$(built debug Debug OFF)"
  sets "-O0 native" "$(built native-debug Debug ON)"
fi

different=$(sort -u "$hashes" | wc -l)
if ((different == 1)); then
  echo "all the same"
else
  echo "$different different states" >&2
  exit 1
fi
