#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Everything built without a warning, and all tests, with each compiler in Release and in Debug.
#   portability.sh [COMPILER TYPE]      one of them: portability.sh clang++-19 Debug
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

compilers=(g++-12 clang++-14 clang++-19) types=(Release Debug)
if (($# == 2)); then
  compilers=("$1") types=("$2")
elif (($# != 0)); then
  echo "usage: portability.sh [COMPILER Release|Debug]" >&2
  exit 2
fi
missing=()
for compiler in "${compilers[@]}"; do type -P "$compiler" >/dev/null || missing+=("$compiler"); done
if ((${#missing[@]} > 0)); then
  echo "portability.sh needs ${missing[*]}" >&2
  exit 2
fi
for compiler in "${compilers[@]}"; do
  for type in "${types[@]}"; do
    build=build/portability/$compiler-$type
    cmake -S . -B "$build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE="$type" -DMAGICMASS_WARNINGS_AS_ERRORS=ON
    cmake --build "$build" -j2
    ctest --test-dir "$build" -j2 --output-on-failure -LE 'time|long'
    echo "passed: $compiler, $type"
  done
done
