#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The library has no global state that changes: whoever calls it from several threads need not know.
#   global_state_test.sh OBJDUMP LIBRARY ...
set -euo pipefail
objdump=$1
# Constants that are computed when they are first asked for: `static const` in a function.
constants='magicmass::(best_instruction_set|scene_keys|scene_kinds|tiers::single_kernels)\(\)::(best|keys|kinds)$'

writable() { # of objdump -t -C: what is in a section that can be written to, but for constants and other libraries'
  awk '$0 ~ /[ \t]\.(data|bss|tdata|tbss)[.\t]/ && $0 !~ /[ \t]\.data\.rel\.ro/ && $0 !~ / d +\./' |
    sed -E 's/^.*\t[0-9a-f]+ +(\.hidden )?//' |
    grep -vE "^(guard variable for )?$constants|^(guard variable for )?(cln|std)::|^DW\.ref\." || true
}

planted=$(printf '0 l     O .%s\t08 %s\n' bss magicmass::last_alpha data magicmass::seed tbss magicmass::cache \
  data.rel.ro magicmass::table bss std::__ioinit bss 'magicmass::scene_keys()::keys' | writable)
[[ $planted == $'magicmass::last_alpha\nmagicmass::seed\nmagicmass::cache' ]] ||
  { echo "the check does not see planted symbols: '$planted'"; exit 1; }

for library in "${@:2}"; do
  symbols=$("$objdump" -t -C "$library")
  if grep -qE '__(asan|tsan|gcov|sanitizer)' <<<"$symbols"; then
    echo "skipped: instrumented, and that has state of its own"
    exit 77
  fi
  found=$(writable <<<"$symbols")
  [[ -z $found ]] || { echo "$library can write to:"; echo "$found"; exit 1; }
  echo "passed: $(basename "$library") keeps nothing between calls"
done
