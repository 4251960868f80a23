#!/usr/bin/env bash
# The tests of the arithmetic on another processor, and the pinned fingerprint of the arrays, under
# qemu. Needs g++-aarch64-linux-gnu and qemu-user (setup --all) and Catch2 2, which is headers
# alone.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
ln -s /usr/include/catch2 "$scratch/catch2"
compile() {
  aarch64-linux-gnu-g++ -std=c++20 -O2 -ffp-contract=off \
    -I. -I../src -I../generated -isystem "$scratch" "$@"
}
for file in src/magicmass/arithmetic/*.cpp catch_main.cpp; do
  compile -c "$file" -o "$scratch/$(basename "$file").o"
done
compile -static "$scratch"/*.o -o "$scratch/test"
qemu-aarch64 "$scratch/test"
cat >"$scratch/main.cpp" <<'END'
#include "src/magicmass/numbers/tiers.hpp"
using namespace magicmass::testing;
int main() { return fingerprint() == pinned_fingerprint ? 0 : 1; }
END
# There is no MPFR, and none of its rows: a call of what is unresolved would crash.
compile -static -Wl,--unresolved-symbols=ignore-all "$scratch/main.cpp" \
  ../src/magicmass/numbers/{arrays,dispatch,for_target,ladder}.cpp -o "$scratch/fingerprint"
qemu-aarch64 "$scratch/fingerprint"
echo "the arrays' fingerprint is that of x86-64"
