#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Line coverage of symbolic/ and src/ by the tests: builds the preset `coverage`, runs the tests named by a pattern (all
# but for time), and prints a line for each folder, and the files with most lines that nothing runs.
#   coverage.sh [PATTERN]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/coverage
unset CCACHE_BASEDIR # else each source has the name that it has from where it is compiled
cmake --preset coverage
cmake --build --preset coverage
rm -rf "$build/profiles"
LLVM_PROFILE_FILE=$PWD/$build/profiles/%m.profraw ctest --preset coverage -R "${1:-.}" | tail -n 5
llvm-profdata merge --sparse "$build"/profiles/*.profraw -o "$build/all.profdata"
programs=()
while read -r program; do programs+=(-object "$program"); done < <(find "$build/bin" "$build/tests" -type f -executable -name 'magicmass*')
llvm-cov export --summary-only --instr-profile="$build/all.profdata" "${programs[@]:1}" symbolic src 2>/dev/null |
  tr '{' '\n' | awk -v top="$PWD/" '
    /"filename":/ { match($0, /"filename":"[^"]*"/); file = substr($0, RSTART + 12, RLENGTH - 13); sub(top, "", file) }
    /"lines":/ { waiting = 1; next }
    waiting {
      waiting = 0
      match($0, /"count":[0-9]+/); count = substr($0, RSTART + 8, RLENGTH - 8)
      match($0, /"covered":[0-9]+/); covered = substr($0, RSTART + 10, RLENGTH - 10)
      if (file == "") next
      n = split(file, part, "/")
      folder = part[1] "/" part[2] (part[1] == "src" && n > 3 ? "/" part[3] : "")
      all[folder] += count; run[folder] += covered; all[part[1]] += count; run[part[1]] += covered
      printf "missed %6d %s %d of %d\n", count - covered, file, covered, count
      file = ""
    }
    END { for (folder in all) printf "%-32s %6.2f %%  %d of %d lines\n", folder, 100 * run[folder] / all[folder], run[folder], all[folder] }
  ' | LC_ALL=C sort >"$build/summary"
grep -v '^missed' "$build/summary"
echo 'files with most lines that no test runs:'
grep '^missed' "$build/summary" | sort -k2,2nr | head -n 15 | sed 's/^missed/      /'
