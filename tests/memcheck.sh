#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Valgrind's memcheck over the runtime, the arithmetic, scenes and a chapter of the derivation, as the preset `default`
# built them; two minutes or so. Fails for memory that is read uninitialised, out of bounds or after its end, and for
# what is definitely lost. A failing test is none of its business: Valgrind has neither AVX-512 nor the 64 bits of a
# long double's mantissa.
#   memcheck.sh [BUILD]
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$(realpath "${1:-$repository/build/default}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

checked() { # what it is; a command line
  local status=0
  valgrind --quiet --error-exitcode=99 --leak-check=full --show-leak-kinds=definite --errors-for-leak-kinds=definite \
    --suppressions="$repository/tests/memcheck.supp" --log-file="$scratch/log" "${@:2}" >"$scratch/output" 2>&1 || status=$?
  if ((status == 99)) || grep -q '^==.*==' "$scratch/log"; then
    failures=$((failures + 1))
    echo "FAILED: $1"
    head -n 40 "$scratch/log"
  else
    echo "clean: $1 (exit code $status)"
  fi
}

printf 'int main() { int x[2]; return x[1] ? new int, 3 : 4; }\n' >"$scratch/planted.cpp"
g++ -O0 -w "$scratch/planted.cpp" -o "$scratch/planted"
if [[ $(checked planted "$scratch/planted") != FAILED* ]]; then
  echo "FAILED: a planted fault is not seen"
  exit 1
fi

cd "$repository"
for scene in tutorials/scenes/*.toml; do
  checked "simulate $scene" "$build/bin/magicmass" simulate "$scene"
done
checked "plan" "$build/bin/magicmass" plan tutorials/scenes/cradle.toml
checked "derive contact" "$build/bin/magicmass" derive contact
checked "count" "$build/bin/magicmass" count --alpha 1e-200
checked "eval" "$build/bin/magicmass" eval --alpha magic:3 --n 2 --digits 40
checked "runtime, exams" "$build/tests/src/magicmass_runtime_tests" '[exam]'
checked "runtime, threads" "$build/tests/src/magicmass_runtime_tests" 'several threads*,functions called*'
checked "arithmetic, exams" "$build/tests/src/magicmass_arithmetic_tests" '[exam]'
((failures == 0))
