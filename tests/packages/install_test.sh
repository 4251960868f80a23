#!/usr/bin/env bash
# Installs a build into an empty prefix, and there uses it in each way that is offered:
# install_test.sh BUILD EXAMPLES. Also: examples as the README has them print what they should.
set -euo pipefail
build=$(realpath "$1")
examples=$(realpath "$2")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$build" --prefix "$scratch/prefix" >/dev/null

cmake -S "$examples" -B "$scratch/found" -DCMAKE_PREFIX_PATH="$scratch/prefix" \
  -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$scratch/found" -j2 >/dev/null
in_readme() { sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/{/^\`\`\`/d;p}" "$examples/../README.md"; }
diff <(in_readme cpp) <(tail -n +3 "$examples/terminal.cpp")
diff <(in_readme text) <("$scratch/found/example_terminal")
[[ $("$scratch/found/example_exact") == "a_2 = 15/64 V" ]]
"$scratch/found/example_arrays" | grep -q '^rho = 1.000000000 at alpha = '
"$scratch/found/example_formula" | grep -q '^formula: '

pc=$(dirname "$(find "$scratch/prefix" -name magicmass.pc)")
# shellcheck disable=SC2046
c++ -std=c++20 "$examples/terminal.cpp" \
  $(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs magicmass) -o "$scratch/by_pkg_config"
diff <(in_readme text) <("$scratch/by_pkg_config")

"$scratch/prefix/bin/magicmass" generate --quantity b_t,rho >"$scratch/wanted.hpp"
cat >"$scratch/wanted.cpp" <<'END'
#include "wanted.hpp"
int main() { return magicmass::generated::terminal_tangent(0.12).b_t > 0.9956 ? 0 : 1; }
END
c++ -std=c++20 -Wall -Wextra -Werror "$scratch/wanted.cpp" -o "$scratch/wanted"
"$scratch/wanted"
sed -i 's/(0.12)/(1)/' "$scratch/wanted.cpp"
if c++ -std=c++20 -fsyntax-only "$scratch/wanted.cpp" 2>"$scratch/said"; then exit 1; fi
grep -q '1\.0, not 1' "$scratch/said"
echo "installed, found by CMake and by pkg-config"
