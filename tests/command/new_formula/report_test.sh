#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# A planted theorem and its form are generated, compiled and reported; the program without them knows nothing of them.
#   report_test.sh CMAKE BUILD PROGRAM PROGRAM_WITH_NEW_FORMULA
set -euo pipefail
cmake=$1 build=$2 program=$3 program_with=$4
failures=0

fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}

report() { # program
  "$1" report --quick --quantities angle --evaluators angle_planted,compile_ex_planted \
    --families everyday --size 8 --rounds 6 --no-growth --format csv
}

log=$("$cmake" --build "$build" --target magicmass_with_new_formula 2>&1) || {
  printf '%s\n' "$log"
  fail "the program with a new formula does not build"
  exit 1
}

rows=$(report "$program_with")
header=${rows%%$'\n'*}
column() { # name; leaves its number
  number=$(tr ',' '\n' <<<"$header" | grep -nx "$1" | cut -d: -f1)
}
column max_ulp && max_ulp=$number
column ns && ns=$number
for precision in float double "long double"; do
  row=$(grep "^angle_planted,everyday,angle,$precision,psi," <<<"$rows") ||
    fail "no row of angle_planted in $precision"
  awk -F, -v ulp="$max_ulp" -v ns="$ns" '{ exit !($ulp > 0 && $ulp < 4 && $ns > 0) }' <<<"$row" ||
    fail "no plausible error and time of angle_planted in $precision: $row"
done
if "$program" report --quick --quantities angle --size 1 --rounds 6 --no-growth | grep -q '^compile_ex_'; then
  grep -q '^compile_ex_planted,' <<<"$rows" || fail "GiNaC does not compile the new formula"
fi

if said=$(report "$program" 2>&1) || [[ $said != *'no evaluator is called "angle_planted"'* ]]; then
  fail "the program without the formula knows it: $said"
fi
((failures == 0)) && echo "passed: a new formula is reported, with no edit but the theorem and its form"
