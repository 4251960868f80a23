#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Numeric headers stop the compiler, with the reason, where arithmetic would not be IEEE's.
#   ieee_arithmetic_test.sh CXX SOURCES
set -euo pipefail
compile() { # header, flags; stderr to stdout
  echo "#include \"$1\"" | "$cxx" -std=c++20 -Wfatal-errors -fsyntax-only "-I$sources/src" "-I$sources/generated" "${@:2}" -x c++ - 2>&1
}
cxx=$1 sources=$2
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
if [[ $("$cxx" --version) == *clang* ]]; then
  parts=(-ffast-math -ffinite-math-only) # it tells of no others
else
  parts=(-ffast-math -ffinite-math-only -funsafe-math-optimizations -freciprocal-math
    "-fassociative-math -fno-signed-zeros -fno-trapping-math")
  [[ $(uname -m) != x86_64 ]] || parts+=(-mfpmath=387)
fi
for header in magicmass/arithmetic/error_free.hpp magicmass/simulator/{three_body,line_motion,velocity_stepping}.hpp; do
  compile "$header" -O2 -march=native >/dev/null || fail "$header does not compile without such flags"
  for flags in "${parts[@]}"; do
    read -ra words <<<"$flags"
    if said=$(compile "$header" "${words[@]}"); then fail "$header compiles with $flags"; fi
    [[ $said == *"magicmass counts on"* ]] || fail "$header with $flags: $said"
  done
  echo "passed: $header"
done
