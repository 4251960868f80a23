#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The same bits from the kernels whichever compiler made them and whichever instruction set they use: digests of 100 003 inputs.
#   compilers_agree_test.sh CMAKE SOURCE DIGEST
# DIGEST is the program as the build made it; one made with clang++-14, or clang++, is compared with it. 77 without one.
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

"$cmake" -S "$source" -B "$scratch/build" -DMAGICMASS_SYMBOLIC=OFF -DMAGICMASS_TESTS=OFF \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$clang" >"$scratch/log"
"$cmake" --build "$scratch/build" -j2 >>"$scratch/log" 2>&1 || { tail -n 20 "$scratch/log"; exit 1; }
library=$(find "$scratch/build" -name 'libmagicmass_runtime.a')
"$clang" -std=c++20 -O2 -ffp-contract=off -I "$source/src" -I "$source/generated" \
  "$source/tests/src/batch/digest.cpp" "$library" -pthread -o "$scratch/digest"
"$scratch/digest" >"$scratch/clang"
if ! agrees "$scratch/built" "$scratch/clang"; then
  echo "FAILED: $clang gives other bits:"
  diff "$scratch/built" "$scratch/clang" || true
  exit 1
fi
cat "$scratch/clang"
echo "passed: $(wc -l <"$scratch/clang") digests are those of the build with $clang, too"
