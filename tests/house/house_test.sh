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
  printf '#include "kernel/a.hpp"\nfor (int i = 0; i < 1; ++i) f();\n' >"$copy/symbolic/codegen/b.cpp"
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
fresh && expect ""
budget=$(awk '$1 == "symbolic/kernel" {print $2}' "$here/rooms.txt")
fresh && for ((i = 2; i < budget; ++i)); do echo "int x$i;"; done >>"$copy/symbolic/kernel/a.cpp" && expect ""
echo 'int last;' >>"$copy/symbolic/kernel/a.cpp" && expect "symbolic/kernel: $((budget + 1)) lines, at most $budget"
fresh && printf 'int y%d;\n' {1..38000} >>"$copy/symbolic/kernel/a.cpp" && expect "all: 38004 lines, at most 38000"
fresh && printf '// %097d\n' 0 >>"$copy/symbolic/kernel/a.cpp" && expect ""
fresh && printf '// %098d\n' 0 >>"$copy/symbolic/kernel/a.cpp" && expect "a.cpp:3: 101 columns"
fresh && echo 'int a = 1; int b = 2;' >>"$copy/symbolic/kernel/a.cpp" && expect "a.cpp:3: two statements"
fresh && mkdir "$copy/generated" && echo 'int a = 1; int b = 2;' >"$copy/generated/a.hpp" && expect "a.hpp:1: two statements"
for two in 'void f() { if (a) { g(); } else { h(); } }' 'call([] { a(); b(); });' '  f(), g();'; do
  fresh && echo "$two" >>"$copy/symbolic/kernel/a.cpp" && expect "a.cpp:3: two statements"
done
fresh && echo 'auto f = [] { for (int i = 0; i < 9; ++i) g(); };' >>"$copy/symbolic/kernel/a.cpp" && expect ""
fresh && echo 'const char* s = "a; b";  // one; two' >>"$copy/symbolic/kernel/a.cpp" && expect ""
fresh && echo 'int a;' >"$copy/symbolic/kernel/a.inc" && expect "a.inc: this ending"
fresh && echo 'int a;' >"$copy/symbolic/kernel/a.ixx" && expect "a.ixx: this ending"
fresh && echo 'int a;' >"$copy/symbolic/kernel/a.cpp.in" && expect "a.cpp.in: this ending"
fresh && printf '\nvoid f();\n' >"$copy/symbolic/kernel/a.txt" && expect "a.txt:2: C++ in a text"
fresh && printf 'f(x) is a function;\n' >"$copy/symbolic/kernel/a.txt" && expect ""
fresh && mkdir "$copy/tests" && echo 'edited lost.cpp kernel' >"$copy/tests/cycle.sh" && expect "tests/cycle.sh: no file lost.cpp"
fresh && echo '#ifdef __AVX2__' >>"$copy/symbolic/kernel/a.cpp" && expect "a.cpp: names a processor"
fresh && mkdir "$copy/generated" && echo '// SPDX-License-Identifier: MIT' >"$copy/generated/a.hpp" && expect ""
fresh && mkdir "$copy/generated" && echo '// SPDX-License-Identifier: BSD' >"$copy/generated/a.hpp" && expect "generated/a.hpp:1: is under MIT"
fresh && echo 'int a;' >"$copy/lost.cpp" && expect "lost.cpp: is in no room"
fresh && for _ in {1..1500}; do echo true; done >"$copy/long.sh" && expect "scripts: 15"
fresh && echo '#include "codegen/b.hpp"' >>"$copy/symbolic/kernel/a.cpp" && expect "symbolic/kernel may not see symbolic/codegen"
fresh && echo '# include  "codegen/b.hpp"' >>"$copy/symbolic/kernel/a.cpp" && expect "symbolic/kernel may not see symbolic/codegen"
fresh && echo '#include "../codegen/b.hpp"' >>"$copy/symbolic/kernel/a.cpp" && expect ": .. in an include"
fresh && echo '#include <codegen/b.hpp>' >>"$copy/symbolic/kernel/a.cpp" && expect "symbolic/kernel may not see symbolic/codegen"
fresh && echo '#include <../codegen/b.hpp>' >>"$copy/symbolic/kernel/a.cpp" && expect ": .. in an include"
fresh && echo '#include "ginac/ginac.h"' >>"$copy/symbolic/kernel/a.cpp" && expect "ginac/ginac.h is no file of ours"
fresh && echo '#include <ginac/ginac.h>' >>"$copy/symbolic/kernel/a.cpp" && expect "symbolic/kernel may not see ginac"
fresh && echo '#include <boost/any.hpp>' >>"$copy/symbolic/kernel/a.cpp" && expect "lacks the package of <boost/any.hpp>"
fresh && echo '# include <boost/any.hpp>' >>"$copy/symbolic/kernel/a.cpp" && expect "lacks the package of <boost/any.hpp>"
for found in 'find_package(Boost)' 'find_package( Boost)' $'find_package(\n  Boost)' 'FIND_LIBRARY(Boost m)' 'pkg_check_modules(x REQUIRED cln Boost)'; do
  fresh && echo "$found" >>"$copy/CMakeLists.txt" && expect "CMake finds as Boost"
done
fresh && sed -i 's/libeigen3-dev//' "$copy/setup" && expect "the plain list lacks libeigen3-dev"
exit $failures
