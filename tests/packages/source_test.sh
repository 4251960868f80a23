#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Uses a checkout as it is, without installing it: source_test.sh SOURCE. Inside of another project, whose library it may
# go into (position-independent code); and alone, without the symbolic part and what that needs.
set -euo pipefail
source=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat >"$scratch/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES CXX)
add_subdirectory("$source" magicmass)
add_subdirectory("$source/examples" examples)
add_library(user SHARED "$source/examples/terminal.cpp")
target_link_libraries(user PRIVATE magicmass::runtime)
END
cmake -S "$scratch" -B "$scratch/inside" >/dev/null
cmake --build "$scratch/inside" -j2 >/dev/null
"$scratch/inside/examples/example_exact" | grep -qx 'a_2 = 15/64 V'

cmake -S "$source" -B "$scratch/alone" -DMAGICMASS_SYMBOLIC=OFF -DMAGICMASS_TESTS=OFF -DCMAKE_BUILD_TYPE=Debug >/dev/null
cmake --build "$scratch/alone" -j2 >/dev/null
cmake --install "$scratch/alone" --prefix "$scratch/prefix" >/dev/null
if grep -E '^(ginac|cln)_' "$scratch/alone/CMakeCache.txt" || [[ -e $scratch/prefix/bin ]]; then exit 1; fi
