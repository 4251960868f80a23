#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Installs the build into a folder, moves it, and uses it from there: the program, CMake and pkg-config.
#   installed_test.sh BUILD VERSION CXX
set -euo pipefail
build=$1 version=$2 compiler=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
expect() { # what it shows, expected, got
  [[ $2 == "$3" ]] || fail "$1: expected '$2', got '$3'"
  echo "passed: $1"
}

cmake --install "$build" --prefix "$scratch/first" >"$scratch/log" || fail "$(tail -5 "$scratch/log")"
mv "$scratch/first" "$scratch/moved"
prefix=$scratch/moved
if grep -rlF -e "$build" -e "$scratch/first" "$prefix"/lib*/cmake "$prefix"/lib*/pkgconfig; then
  fail "these know where they were built or first installed"
fi
for file in bin/magicmass share/man/man1/magicmass-eval.1 share/bash-completion/completions/magicmass \
  share/zsh/vendor-completions/_magicmass share/fish/vendor_completions.d/magicmass.fish \
  share/magicmass/scenes/cradle.toml share/magicmass/schemas/eval.json include/magicmass/fast.hpp \
  include/magicmass/velocities_product.hpp include/magicmass-symbolic/proof/kernel.hpp; do
  [[ -s $prefix/$file ]] || fail "$file is not installed"
done

expect "the program's version is the project's" "magicmass $version" "$("$prefix/bin/magicmass" --version)"
expect "the program finds its files where it was moved to" "up to date: N files in $prefix/share/magicmass/generated" \
  "$("$prefix/bin/magicmass" generate --check | sed -E 's/: [0-9]+ files/: N files/')"

exercises=$prefix/share/magicmass/tutorials
checked() { # an exercise: what is said of its own solution
  "$prefix/bin/magicmass" learn check "$1" "$(echo "$exercises"/*/exercises/"$1"/solution/answer.cpp)" --folder "$scratch/student"
}
said=$(checked share_nodes) || fail "learn check share_nodes, whose program is lowered on the spot: $said"
said=$(checked beat_us) || fail "learn check beat_us: $said"
[[ $said == *"product: worst error"* ]] || fail "no contest with the installed headers: $said"
echo "passed: exercises in C++ work where they are installed"

cmake -S "$here/project" -B "$scratch/user" -DCMAKE_PREFIX_PATH="$prefix" -DWITH_SYMBOLIC=ON >/dev/null
cmake --build "$scratch/user" >"$scratch/log" 2>&1 || fail "$(cat "$scratch/log")"
expect "CMake: runtime" "3 + 3, 0.995649, 3 bodies" "$("$scratch/user/count")"
expect "CMake: symbolic" "equal" "$("$scratch/user/prove" | cut -d, -f1)"

if ! type -P pkg-config >/dev/null; then
  echo "skipped: no pkg-config"
  exit 0
fi
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name magicmass.pc)")
export PKG_CONFIG_PATH
expect "pkg-config's version is the project's" "$version" "$(pkg-config --modversion magicmass)"
read -ra flags < <(pkg-config --cflags --libs magicmass)
"$compiler" -std=c++20 "$here/project/count.cpp" "${flags[@]}" -o "$scratch/count"
expect "pkg-config: runtime" "3 + 3, 0.995649, 3 bodies" "$("$scratch/count")"
read -ra flags < <(pkg-config --cflags --libs magicmass-symbolic)
"$compiler" -std=c++20 "$here/project/prove.cpp" "${flags[@]}" -o "$scratch/prove"
expect "pkg-config: symbolic" "equal" "$("$scratch/prove" | cut -d, -f1)"
