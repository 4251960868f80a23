#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# What is compiled for one instruction set alone must not offer the linker an inline function that other files
# have too: it could be kept for the whole program, and stop it on a lesser processor.
#   symbols_test.sh LIBRARY NM
set -euo pipefail
library=$1 nm=${2:-nm}

shared_symbols() { # of the kernels' objects, the weak functions that are in no namespace of an instruction set; tables are the same in all
  awk '/:$/ { object = $0 } object ~ /kernels\.cpp/ && / W / { sub(/^[0-9a-f]* /, ""); print }' |
    grep -vE '(arithmetic|batch|generated)::(baseline|avx2|avx512)::' || true
}

planted=$(printf '%s\n' 'kernels.cpp.o:' '0000 W magicmass::batch::avx2::fine(int)' '0000 W std::sqrt(float)' |
  shared_symbols)
[[ $planted == 'W std::sqrt(float)' ]] || { echo "the check does not see a planted symbol: '$planted'"; exit 1; }

symbols=$("$nm" --defined-only --demangle "$library")
tables=$(grep -cE ' [RD] magicmass::batch::tables::(baseline|avx2|avx512)$' <<<"$symbols") || true
[[ $tables == 3 ]] || { echo "expected the three tables of kernels in $library, found $tables"; exit 1; }
found=$(shared_symbols <<<"$symbols")
[[ -z $found ]] || { echo "compiled for one instruction set, visible to all:"; echo "$found"; exit 1; }
echo "passed: the kernels of the three instruction sets share no inline function"
