#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# How long each generated header takes to compile by itself; more than 2 s fail.
#   compile_time_test.sh COMPILER SOURCE
set -euo pipefail
compiler=$1 source=$2
longest=2
slow=0
cd "$source/generated"
for header in magicmass/*.hpp magicmass/*/*.hpp; do
  start=$(date +%s%N)
  printf '#include "%s"\n' "$header" |
    "$compiler" -std=c++20 -O2 -ffp-contract=off -I . -I ../src -x c++ -c - -o /dev/null
  seconds=$(awk "BEGIN { print ($(date +%s%N) - $start) / 1e9 }")
  printf '%5.2f s  %6d bytes  %s\n' "$seconds" "$(wc -c <"$header")" "$header"
  if awk "BEGIN { exit !($seconds > $longest) }"; then slow=$((slow + 1)); fi
done
((slow == 0)) || { echo "FAILED: $slow headers take more than $longest s"; exit 1; }
