#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Instructions that a call of each scalar function takes, by callgrind, on everyday inputs; a figure and no verdict but that there
# is one. Valgrind has no AVX-512, so these are the functions for AVX2. 77 where there is no valgrind.
#   instruction_counts_test.sh SCALAR_CALLS
set -euo pipefail
program=$1
type -P valgrind >/dev/null || { echo "skipped: no valgrind"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

instructions() { # function, calls
  valgrind --tool=callgrind --callgrind-out-file="$scratch/out" "$program" "$1" "$2" 2>&1 >/dev/null |
    sed -nE 's/.*Collected : ([0-9]+).*/\1/p'
}
per_call() { # the difference of two lengths: what begins and ends the program does not count
  local few many
  few=$(instructions "$1" 1000) many=$(instructions "$1" 3000)
  [[ $few -gt 0 && $many -gt $few ]] || { echo "no count of $1" >&2; return 1; }
  echo $(((many - few) / 2000))
}

loop=$(per_call nothing)
declare -A count
for function in naive_velocities fast_velocities accurate_velocities naive_terminal fast_terminal accurate_terminal \
  naive_counts exact_counts; do
  count[$function]=$(($(per_call $function) - loop))
  naive=${count[naive_${function#*_}]}
  printf '%-20s %6d instructions a call, %5.2f of naive\n' $function "${count[$function]}" \
    "$(awk "BEGIN { print ${count[$function]} / $naive }")"
  ((count[$function] > 5))
done
