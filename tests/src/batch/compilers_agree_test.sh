#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The same bits from the kernels whichever compiler made them and whichever instruction set they use: digests of 100 003 inputs.
#   compilers_agree_test.sh CMAKE SOURCE DIGEST INSTALLED|every
# DIGEST is the program as the build made it; one made with clang++-14, or clang++, on what is INSTALLED, from
# runtime_without_symbolic, is compared with it. 77 without one.
# `every`: g++ 12, clang 14 and clang 19, Debug and Release, and the whole library for AVX2 and for this machine.
set -euo pipefail
cmake=$1 source=$2 digest=$3

digests_of_each() { # of lines "function  instruction set  digest", function and digest, each once
  sed -E 's/ +[a-z0-9]+ +([0-9a-f]{16})$/ \1/' | sort -u
}
agrees() { # two files of digests
  [[ $(cat "$1" "$2" | digests_of_each | wc -l) == $(digests_of_each <"$1" | sed -E 's/ [0-9a-f]+$//' | sort -u | wc -l) ]]
}

clang=$(type -P clang++-14 || type -P clang++) || { echo "skipped: no clang++"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$digest" >"$scratch/built"
"$digest" spoil >"$scratch/spoilt"
if agrees "$scratch/built" "$scratch/spoilt"; then
  echo "FAILED: a wrong bit is not seen"
  exit 1
fi
if ! agrees "$scratch/built" "$scratch/built"; then
  echo "FAILED: instruction sets disagree:"
  cat "$scratch/built"
  exit 1
fi

# Where the library is, a compiler, a build type and further flags; fails if the program that they make disagrees.
linked_agrees() {
  local library optimisation=-O2
  library=$(find "$1" -name 'libmagicmass_runtime.a')
  [[ -n $library ]] || { echo "FAILED: no library below $1"; exit 1; }
  shift
  if [[ $2 == Debug ]]; then optimisation=-O0; fi
  # shellcheck disable=SC2086
  "$1" -std=c++20 $optimisation ${3-} -ffp-contract=off -I "$source/src" -I "$source/generated" \
    "$source/tests/src/batch/digest.cpp" "$library" -pthread -o "$scratch/digest"
  "$scratch/digest" >"$scratch/other"
  if ! agrees "$scratch/built" "$scratch/other"; then
    echo "FAILED: $* gives other bits:"
    diff "$scratch/built" "$scratch/other" || true
    exit 1
  fi
  echo "passed: $(wc -l <"$scratch/other") digests are those of the build with $*, too"
}
agrees_with() { # a compiler, a build type and further flags
  rm -rf "$scratch/build"
  "$cmake" -S "$source" -B "$scratch/build" -DMAGICMASS_SYMBOLIC=OFF -DMAGICMASS_TESTS=OFF \
    -DCMAKE_BUILD_TYPE="$2" -DCMAKE_CXX_COMPILER="$1" -DCMAKE_CXX_FLAGS="${3-}" >"$scratch/log"
  "$cmake" --build "$scratch/build" -j2 --target magicmass_runtime >>"$scratch/log" 2>&1 ||
    { tail -n 20 "$scratch/log"; exit 1; }
  linked_agrees "$scratch/build" "$@"
}
if [[ ${4-} == every ]]; then
  for compiler in g++-12 clang++-14 clang++-19; do
    type -P $compiler >/dev/null || { echo "skipped: no $compiler"; continue; }
    for build_type in Release Debug; do agrees_with $compiler $build_type; done
  done
  agrees_with g++ Release '-mavx2 -mfma'
  agrees_with "$clang" Release '-march=native'
  exit
fi
linked_agrees "$4" "$clang" Release
cat "$scratch/other"
