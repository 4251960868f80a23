#!/usr/bin/env bash
# Uses a checkout as it is, inside of another project: source_test.sh SOURCE. A library of that may
# take it in (position-independent code), its warnings are not ours; and it is installed from there,
# into folders of other names. The project alone can be had without the symbolic part.
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
cmake -S "$scratch" -B "$scratch/inside" -DMAGICMASS_INSTALL=ON \
  -DCMAKE_INSTALL_PREFIX="$scratch/prefix" -DCMAKE_INSTALL_INCLUDEDIR=include/own \
  -DCMAKE_INSTALL_LIBDIR="$scratch/prefix/own/lib" >/dev/null
cmake --build "$scratch/inside" -j2 >/dev/null
"$scratch/inside/examples/example_exact" | grep -qx 'a_2 = 15/64 V'
cmake --install "$scratch/inside" >/dev/null
cmake -S "$source/examples" -B "$scratch/found" \
  -Dmagicmass_DIR="$scratch/prefix/own/lib/cmake/magicmass" >/dev/null
cmake --build "$scratch/found" -j2 >/dev/null
# shellcheck disable=SC2046
c++ -std=c++20 "$source/examples/terminal.cpp" -o "$scratch/by_pkg_config" \
  $(PKG_CONFIG_PATH="$scratch/prefix/own/lib/pkgconfig" pkg-config --cflags --libs magicmass)
"$scratch/by_pkg_config" | grep -q '^3 + 3 collisions'
if [[ -e $scratch/prefix/bin ]]; then exit 1; fi

# The same files, without the symbolic part: nothing looks for what that needs.
cmake -S "$source" -B "$scratch/alone" -DMAGICMASS_SYMBOLIC=OFF -DMAGICMASS_TESTS=OFF >/dev/null
if grep -E '^(ginac|cln)_' "$scratch/alone/CMakeCache.txt"; then exit 1; fi
