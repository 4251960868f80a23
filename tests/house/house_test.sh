#!/usr/bin/env bash
# Each rule of the house can fail: broken one at a time in a small copy, it is named.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
failures=0
fresh() {
  rm -rf "${copy:?}"/*
  mkdir -p "$copy/symbolic/kernel" "$copy/symbolic/codegen" "$copy/src/magicmass/oracle"
  cp "$here/../../setup" "$copy/setup"
  printf '#include <cln/rational.h>\nint one() { return 1; }\n' >"$copy/symbolic/kernel/a.cpp"
  printf '%s\n' '#include "kernel/a.hpp"' 'for (int i = 0; i < 1; ++i) f();' \
    >"$copy/symbolic/codegen/b.cpp"
  touch "$copy/symbolic/kernel/a.hpp" "$copy/symbolic/codegen/b.hpp"
  echo 'find_package(Eigen3 REQUIRED)' >"$copy/CMakeLists.txt"
}
expect() { # "" or a part of what is said
  local said status=0
  said=$(bash "$here/house.sh" "$copy" 2>&1 >/dev/null) || status=$?
  if [[ -z $1 && $status != 0 ]] || [[ -n $1 && ($status != 1 || $said != *"$1"*) ]]; then
    printf 'expected "%s", got (%s):\n%s\n' "$1" "$status" "$said"
    failures=1
  fi
}
added() { # FILE LINE EXPECTED: a fresh copy in which the file ends with this line
  fresh
  mkdir -p "$(dirname "$copy/$1")"
  printf '%s\n' "$2" >>"$copy/$1"
  expect "$3"
}
a=symbolic/kernel/a.cpp
fresh && expect ""
budget=$(awk '$1 == "symbolic/kernel" {print $2}' "$here/rooms.txt")
added $a "$(printf 'int x%d;\n' $(seq 2 $((budget - 1))))" ""
echo 'int last;' >>"$copy/$a"
expect "symbolic/kernel: $((budget + 1)) lines, at most $budget"
added $a "$(printf 'int y%d;\n' {1..38000})" "all: 38004 lines, at most 38000"
added $a "$(printf '// %097d' 0)" ""
added $a "$(printf '// %098d' 0)" "a.cpp:3: more than 100 columns"
for file in a.sh b.gp symbolic/CMakeLists.txt README.md; do
  added $file "$(printf '# %098d' 0)" ""
  added $file "$(printf '# %099d' 0)" "$file:1: more than 100 columns"
done
added README.md "$(printf '| %099d |' 0)" ""
added README.md "$(printf 'α%.0s' {1..100})" ""
added $a 'int a = 1; int b = 2;' "a.cpp:3: two statements"
added generated/a.hpp 'int a = 1; int b = 2;' "a.hpp:1: two statements"
for two in 'void f() { if (a) { g(); } else { h(); } }' 'call([] { a(); b(); });' '  f(), g();'; do
  added $a "$two" "a.cpp:3: two statements"
done
added $a 'auto f = [] { for (int i = 0; i < 9; ++i) g(); };' ""
added $a 'const char* s = "a; b";  // one; two' ""
added symbolic/kernel/a.inc 'int a;' "a.inc: this ending"
added symbolic/kernel/a.ixx 'int a;' "a.ixx: this ending"
added symbolic/kernel/a.cpp.in 'int a;' "a.cpp.in: this ending"
added symbolic/kernel/a.txt $'\nvoid f();' "a.txt:2: C++ in a text"
added symbolic/kernel/a.txt 'f(x) is a function;' ""
added tests/cycle.sh 'edited lost.cpp kernel' "tests/cycle.sh: no file lost.cpp"
added $a '#ifdef __AVX2__' "a.cpp: names a processor"
added generated/a.hpp '// SPDX-License-Identifier: MIT' ""
added generated/a.hpp '// SPDX-License-Identifier: BSD' "generated/a.hpp:1: is under MIT"
added lost.cpp 'int a;' "lost.cpp: is in no room"
fresh && for _ in {1..1500}; do echo true; done >"$copy/long.sh" && expect "scripts: 15"
added $a '#include "codegen/b.hpp"' "symbolic/kernel may not see symbolic/codegen"
added $a '# include  "codegen/b.hpp"' "symbolic/kernel may not see symbolic/codegen"
added $a '#include "../codegen/b.hpp"' ": .. in an include"
added $a '#include <codegen/b.hpp>' "symbolic/kernel may not see symbolic/codegen"
added $a '#include <../codegen/b.hpp>' ": .. in an include"
added $a '#include "ginac/ginac.h"' "ginac/ginac.h is no file of ours"
added $a '#include <ginac/ginac.h>' "symbolic/kernel may not see ginac"
added $a '#include <boost/any.hpp>' "lacks the package of <boost/any.hpp>"
added $a '# include <boost/any.hpp>' "lacks the package of <boost/any.hpp>"
for found in 'find_package(Boost)' 'find_package( Boost)' $'find_package(\n  Boost)' \
  'FIND_LIBRARY(Boost m)' 'pkg_check_modules(x REQUIRED cln Boost)'; do
  added CMakeLists.txt "$found" "CMake finds as Boost"
done
fresh && sed -i 's/libeigen3-dev//' "$copy/setup" && expect "the plain list lacks libeigen3-dev"
exit $failures
