#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The tests of the arithmetic on another processor, their pinned fingerprint among them, under qemu. Needs
# g++-aarch64-linux-gnu and qemu-user (setup --all) and Catch2 2, which is headers alone.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
ln -s /usr/include/catch2 "$scratch/catch2"
for file in src/magicmass/arithmetic/*.cpp catch_main.cpp; do
  aarch64-linux-gnu-g++ -std=c++20 -O2 -ffp-contract=off -I. -I../src -I../generated -isystem "$scratch" \
    -c "$file" -o "$scratch/$(basename "$file").o"
done
aarch64-linux-gnu-g++ -static "$scratch"/*.o -o "$scratch/test"
qemu-aarch64 "$scratch/test"
