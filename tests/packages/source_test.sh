#!/usr/bin/env bash
# Uses a checkout as it is, without installing it: source_test.sh SOURCE. Inside of another project,
# whose library it may go into (position-independent code), and whose warnings are not ours; and
# alone, without the symbolic part and what that needs, installed into folders of other names.
set -euo pipefail
source=$(realpath "$1")
if grep -E '[a-z]-[0-9]+-dev' "$source/setup"; then exit 1; fi # a package of one Debian only
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cat >"$scratch/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES CXX)
add_compile_options(-Wall -Wextra -Wconversion -Wshadow -Wold-style-cast -Wundef -Werror)
add_subdirectory("$source" magicmass)
add_subdirectory("$source/examples" examples)
add_library(user SHARED "$source/examples/terminal.cpp")
target_link_libraries(user PRIVATE magicmass::runtime)
END
cmake -S "$scratch" -B "$scratch/inside" >/dev/null
cmake --build "$scratch/inside" -j2 >/dev/null
"$scratch/inside/examples/example_exact" | grep -qx 'a_2 = 15/64 V'

cmake -S "$source" -B "$scratch/alone" -DMAGICMASS_SYMBOLIC=OFF -DMAGICMASS_TESTS=OFF \
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_INSTALL_PREFIX="$scratch/prefix" \
  -DCMAKE_INSTALL_INCLUDEDIR=include/own \
  -DCMAKE_INSTALL_LIBDIR="$scratch/prefix/own/lib" >/dev/null
cmake --build "$scratch/alone" -j2 >/dev/null
cmake --install "$scratch/alone" >/dev/null
cmake -S "$source/examples" -B "$scratch/found" \
  -Dmagicmass_DIR="$scratch/prefix/own/lib/cmake/magicmass" >/dev/null
cmake --build "$scratch/found" -j2 >/dev/null
# shellcheck disable=SC2046
c++ "$source/examples/terminal.cpp" -o "$scratch/by_pkg_config" \
  $(PKG_CONFIG_PATH="$scratch/prefix/own/lib/pkgconfig" pkg-config --cflags --libs magicmass)
"$scratch/by_pkg_config" | grep -q '^3 + 3 collisions'
if grep -E '^(ginac|cln)_' "$scratch/alone/CMakeCache.txt"; then exit 1; fi
if [[ -e $scratch/prefix/bin ]]; then exit 1; fi
