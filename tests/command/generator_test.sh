#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The generator that needs none of what it writes (that it was built says so: generated/ is not where it looks for headers)
# writes generated/ from nothing, and mends a stale one.
#   generator_test.sh GENERATOR SOURCE
set -euo pipefail
generator=$1 source=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

fail() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}
is_current() { diff -r --exclude=CMakeLists.txt "$source/generated" "$scratch/generated" >/dev/null; }

"$generator" --out "$scratch/generated"
is_current || fail "what it writes from nothing is not generated/"
rm "$scratch/generated/magicmass/kernels/angle.hpp"
echo "#error stale" >"$scratch/generated/magicmass/quantities.hpp"
if is_current; then fail "a stale folder passes"; fi
"$generator" --out "$scratch/generated"
is_current || fail "it does not mend a stale folder"

for arguments in "" "generated" "--out"; do
  status=0
  # shellcheck disable=SC2086 # each word is an argument
  said=$("$generator" $arguments 2>&1) || status=$?
  [[ $status == 2 && $(wc -l <<<"$said") == 1 ]] || fail "'$arguments' is not refused in a line: $status $said"
done
status=0
said=$("$generator" --out /dev/null/folder 2>&1) || status=$?
[[ $status == 2 && $said == *"cannot write"* ]] || fail "a folder that cannot be: $status $said"
((failures == 0)) && echo "passed: the generator needs nothing of what it writes"
