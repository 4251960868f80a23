#!/usr/bin/env bash
# How long one edit takes to its own tests' verdict, in a build that is up to date: cycle.sh
# [BUILD]. Prints three times.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/default}
cmake --build "$build" -j2 >/dev/null
edited() { # file, test
  touch "$1"
  local begin=$SECONDS
  cmake --build "$build" -j2 --target "test_$2" >/dev/null
  "$build/bin/test_$2" >/dev/null
  printf '%-40s %-12s %3d s\n' "$1" "$2" $((SECONDS - begin))
}
edited symbolic/derivation/power.cpp derivation
edited symbolic/codegen/passes/names.cpp codegen
edited src/magicmass/numbers/ladder.cpp numbers
