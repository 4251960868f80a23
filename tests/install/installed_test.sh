#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Installs the build into a folder, moves it, and uses it from there: the program, CMake and pkg-config.
#   installed_test.sh BUILD VERSION CXX
set -euo pipefail
build=$1 version=$2 compiler=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
examples=$here/../../examples
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

# The course needs pandoc, and is left out without it.
mkdir "$scratch/bin"
for folder in /usr/bin /bin; do ln -sf "$folder"/* "$scratch/bin"; done
rm -f "$scratch/bin/pandoc"
rm -rf "$build/installed"
PATH=$scratch/bin cmake --install "$build" --prefix "$scratch/small" --component program >"$scratch/log" || fail "without pandoc: $(tail -5 "$scratch/log")"
grep -q "Not installed: .*pandoc" "$scratch/log" || fail "without pandoc nothing is said of the course"
[[ -x $scratch/small/bin/magicmass && ! -e $scratch/small/share/doc/magicmass/course ]] || fail "without pandoc: other files"
echo "passed: without pandoc it installs all but the course, and says so"

cmake --install "$build" --prefix "$scratch/first" >"$scratch/log" || fail "$(tail -5 "$scratch/log")"
mv "$scratch/first" "$scratch/moved"
prefix=$scratch/moved
if grep -rlF -e "$build" -e "$scratch/first" "$prefix"/lib*/cmake "$prefix"/lib*/pkgconfig; then
  fail "these know where they were built or first installed"
fi
for file in bin/magicmass share/man/man1/magicmass-eval.1 share/bash-completion/completions/magicmass \
  share/zsh/vendor-completions/_magicmass share/fish/vendor_completions.d/magicmass.fish \
  share/magicmass/scenes/cradle.toml share/magicmass/schemas/eval.json include/magicmass/fast.hpp \
  include/magicmass/velocities_tangent.hpp include/magicmass-symbolic/proof/kernel.hpp; do
  [[ -s $prefix/$file ]] || fail "$file is not installed"
done

if type -P pandoc >/dev/null; then
  for page in index 01_contact 13_speed_and_error derivation; do
    [[ -s $prefix/share/doc/magicmass/course/$page.html ]] || fail "$page.html of the course is not installed"
  done
  echo "passed: the course"
else
  echo "skipped: the course needs pandoc (./setup --all)"
fi
expect "the changelog begins with the project's version" "## $version" \
  "$(grep -m 1 '^## ' "$prefix/share/doc/magicmass/CHANGELOG.md" | cut -d ' ' -f 1,2)"
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

cmake -S "$here/project" -B "$scratch/user" -DCMAKE_PREFIX_PATH="$prefix" -DASKED_VERSION="$version" -DWITH_SYMBOLIC=ON >/dev/null
cmake --build "$scratch/user" >"$scratch/log" 2>&1 || fail "$(cat "$scratch/log")"
for name in evaluate count simulate plan prove; do
  diff "$examples/expected_output/$name.txt" <("$scratch/user/examples/$name") || fail "CMake: example $name"
done
expect "CMake: example generate" "double beta_k" "$("$scratch/user/examples/generate" | grep -o 'double beta_k')"
expect "CMake: scenes" "3 bodies" "$("$scratch/user/scene")"

bash "$here/public_headers_test.sh" "$prefix/include" || fail "public headers"
if ! type -P pkg-config >/dev/null; then
  echo "skipped: no pkg-config"
  exit 0
fi
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name magicmass.pc)")
export PKG_CONFIG_PATH
expect "pkg-config's version is the project's" "$version" "$(pkg-config --modversion magicmass)"
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
for pair in count:magicmass plan:magicmass-symbolic; do
  name=${pair%:*} package=${pair#*:}
  read -ra flags < <(pkg-config --cflags --libs "$package")
  "$compiler" -std=c++20 "${warnings[@]}" "$examples/$name.cpp" "${flags[@]}" -o "$scratch/$name"
  expect "pkg-config: $package" "$(<"$examples/expected_output/$name.txt")" "$("$scratch/$name")"
done

# Every public header by itself is a whole, and brings no warning to who includes it.
{ find "$prefix/include/magicmass" -name '*.hpp' -printf 'magicmass/%P\n' &&
  find "$prefix/include/magicmass-symbolic" -name '*.hpp' -printf '%P\n'; } | grep -v eigen.hpp | sort -R |
  sed 's/.*/#include "&"/' >"$scratch/all.cpp"
read -ra flags < <(pkg-config --cflags magicmass-symbolic)
"$compiler" -std=c++20 -fsyntax-only "${warnings[@]}" "${flags[@]}" "$scratch/all.cpp" || fail "$(cat "$scratch/all.cpp")"
expect "headers in any order, without a warning" 1 "$(grep -c fast.hpp "$scratch/all.cpp")"
