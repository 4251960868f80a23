#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# A planted theorem, its form and a form of a new quantity are generated, compiled and reported; the program without them
# knows nothing of them.
#   report_test.sh CMAKE BUILD PROGRAM PROGRAM_WITH_NEW_FORMULA
set -euo pipefail
cmake=$1 build=$2 program=$3 program_with=$4
failures=0
errors=$(mktemp)
trap 'rm -f "$errors"' EXIT

fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}

report() { # program, quantities, evaluators
  "$1" report --quick --quantities "$2" --evaluators "$3" --families everyday --size 8 --rounds 6 \
    --no-growth --format csv
}

log=$("$cmake" --build "$build" --target magicmass_with_new_formula 2>&1) || {
  printf '%s\n' "$log"
  fail "the program with a new formula does not build"
  exit 1
}

rows=$(report "$program_with" angle,half_turn angle_planted,compile_ex_planted,half_turn_planted 2>"$errors")
column() { # name; prints its number
  tr ',' '\n' <<<"${rows%%$'\n'*}" | grep -nx "$1" | cut -d: -f1
}

expect_row() { # evaluator, quantity, precision, member, is there a ratio to naive: 1 or 0
  local row
  row=$(grep "^$1,everyday,$2,$3,$4," <<<"$rows") || fail "no row of $1 in $3"
  awk -F, -v ulp="$(column max_ulp)" -v ns="$(column ns)" -v ratio="$(column ratio)" -v is_compared="$5" \
    '{ exit !($ulp > 0 && $ulp < 4 && $ns > 0 && ($ratio > 0) == is_compared) }' <<<"$row" ||
    fail "no plausible error and time of $1 in $3: $row"
}

for precision in float double "long double"; do
  expect_row angle_planted angle "$precision" psi 1
  expect_row half_turn_planted half_turn "$precision" cosine 0
done
grep -q '^magicmass: half_turn: .* errors are against its own theorem' "$errors" ||
  fail "nothing says what a new quantity is compared with"
if ! grep -q "skipped: GiNaC's compile_ex" "$errors"; then
  for quantity in angle half_turn; do
    grep -q "^compile_ex_planted,everyday,$quantity," <<<"$rows" ||
      fail "GiNaC does not compile the new formula of $quantity"
  done
fi

if said=$(report "$program" angle angle_planted 2>&1) || [[ $said != *'no evaluator is called "angle_planted"'* ]]; then
  fail "the program without the formula knows it: $said"
fi
if said=$(report "$program" half_turn naive 2>&1) || [[ $said != *'no quantity is called "half_turn"'* ]]; then
  fail "the program without the quantity knows it: $said"
fi
((failures == 0)) && echo "passed: new formulas are reported, with no edit but the theorem and the forms"
