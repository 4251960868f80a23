#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Drops each guard of the kernel in turn, and bends each rule as mutants.txt says: the tests must turn red.
# usage: mutants.sh COMPILER SOURCE_DIR KERNEL_LIBRARY TEST_OBJECT_OR_LIBRARY...
set -euo pipefail
export compiler=$1 source=$2 library=$3
shift 3
export objects="$*" list=$source/tests/symbolic/kernel/mutants.txt
export kernel=$source/symbolic/kernel
work=$(mktemp -d)
export work
trap 'rm -rf "$work"' EXIT
printf '#include <string>\nnamespace kernel {\ninline void ignore(const std::string&) {}\n}\n' >"$work/ignore.hpp"

# Compiles FILE as changed in FOLDER, links it before the library, runs the tests: 0 if they stay green.
survives() {
  local folder=$1 file=$2
  "$compiler" -std=c++20 -O0 -w -ffp-contract=off -I"$source/symbolic" -include "$work/ignore.hpp" \
    -c "$folder/$file" -o "$folder/mutant.o" 2>"$folder/errors" || { echo "DOES NOT COMPILE"; return 1; }
  # shellcheck disable=SC2086
  "$compiler" "$folder/mutant.o" $objects "$library" -lcln -o "$folder/tests" 2>"$folder/errors" ||
    { echo "DOES NOT LINK"; return 1; }
  timeout 60 "$folder/tests" >/dev/null 2>&1
}
# One mutant: a file, a sed command, what it does.
try() {
  local file=$1 command=$2 what=$3 folder verdict
  folder=$(mktemp -d "$work/XXXXXX")
  sed -e "$command" "$kernel/$file" >"$folder/$file"
  if cmp -s "$kernel/$file" "$folder/$file"; then
    echo "CHANGES NOTHING  $file: $what"
  elif verdict=$(survives "$folder" "$file"); then
    echo "SURVIVED  $file: $what"
  elif [ -n "$verdict" ]; then
    echo "$verdict  $file: $what"
  fi
  rm -rf "$folder"
}
export -f survives try

# Lines `file|sed command|reason`: with a reason the mutant is equivalent, and is not tried.
guards() {
  local path file number line
  for path in "$kernel"/*.cpp; do
    file=${path##*/}
    grep -n 'refuse(' "$path" | grep -v 'void refuse' | while IFS=: read -r number line; do
      line=${line#"${line%%[![:space:]]*}"}
      grep -qF "$file|guard|$line|" "$list" || printf '%s\0%s\0%s\0' "$file" "${number}s/refuse(/ignore(/" "$line"
    done
  done
}
# Of names, the reasons why one is none are guards, too.
reasons() {
  grep -nE 'return (read_as_index|name \+|"\\"")' "$kernel/names.cpp" | grep -v 'could be read' |
    while IFS=: read -r number line; do
      printf '%s\0%s\0%s\0' names.cpp "${number}s/return .*;/;/" "$line"
    done
}
bends() {
  local file command
  while IFS='|' read -r file command; do
    case $file in '' | '#'*) continue ;; esac
    case $command in guard\|*) continue ;; esac
    printf '%s\0%s\0%s\0' "$file" "$command" "$command"
  done <"$list"
}
{ guards; reasons; bends; } >"$work/mutants"
count=$(($(tr -cd '\0' <"$work/mutants" | wc -c) / 3))
xargs -0 -n 3 -P "$(nproc)" bash -c 'try "$@"' _ <"$work/mutants" | tee "$work/verdicts"
echo "$count mutants, $(wc -l <"$work/verdicts") not turned red"
test ! -s "$work/verdicts"
