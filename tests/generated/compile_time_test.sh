#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# How much processor time each generated header takes to compile by itself; more than 2 s fail.
#   compile_time_test.sh COMPILER SOURCE
set -euo pipefail
compiler=$1 source=$2
longest=2
compile() { # header
  printf '#include "%s"\n' "$1" |
    "$compiler" -std=c++20 -O2 -ffp-contract=off -I . -I ../src -x c++ -c - -o /dev/null
}
seconds_of() { # command; its output is lost
  local TIMEFORMAT='%U %S'
  { time "$@" >/dev/null 2>&3; } 3>&2 2>&1 | awk '{ print $1 + $2 }'
}
is_slow() { awk "BEGIN { exit !($1 > $longest) }"; } # seconds
if is_slow 1.99 || ! is_slow 2.01; then
  echo "FAILED: the limit is not $longest s"
  exit 1
fi
slow=0
cd "$source/generated"
for header in magicmass/*.hpp magicmass/*/*.hpp; do
  seconds=$(seconds_of compile "$header")
  printf '%5.2f s  %6d bytes  %s\n' "$seconds" "$(wc -c <"$header")" "$header"
  if is_slow "$seconds"; then slow=$((slow + 1)); fi
done
((slow == 0)) || { echo "FAILED: $slow headers take more than $longest s"; exit 1; }
