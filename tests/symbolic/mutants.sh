#!/usr/bin/env bash
# Bends each rule of a room of symbolic/ as its mutants.txt says, and drops each guard in turn: the
# tests must turn red.
# usage: mutants.sh ROOM SECONDS SOURCE_DIR COMPILER OPTIMIZATION TEST_OBJECT_OR_LIBRARY...
set -euo pipefail
export room=$3/symbolic/$1 list=$3/tests/symbolic/$1/mutants.txt
export seconds=$2 source=$3 compiler=$4 optimization=$5
shift 5
export objects="$*"
work=$(mktemp -d)
export work
trap 'rm -rf "$work"' EXIT
printf '%s\n' '#include <string>' 'namespace kernel {' 'inline void ignore(const std::string&) {}' \
  '}' >"$work/ignore.hpp"

# The room's files one by one: its library may have several in one.
cd "$room"
mkdir "$work/sound"
# shellcheck disable=SC2016
printf '%s\0' *.cpp */*.cpp | xargs -0 -P "$(nproc)" -I {} bash -c '[[ ! -e $1 ]] ||
  "$compiler" -std=c++20 -O1 -w -ffp-contract=off -I"$source/symbolic" -c "$1" \
    -o "$work/sound/${1##*/}.o"' _ {}
cd "$work"

# Compiles FILE as changed in FOLDER, links it with the room's others before the libraries, runs the
# tests: 0 if they stay green.
survives() {
  local folder=$1 file=$2
  "$compiler" -std=c++20 "$optimization" -w -ffp-contract=off -I"$source/symbolic" \
    -include "$work/ignore.hpp" -c "$folder/$file" -o "$folder/mutant.o" 2>"$folder/errors" ||
    { echo "DOES NOT COMPILE"; return 1; }
  local others
  others=$(find "$work/sound" ! -name "$file.o" -type f)
  # shellcheck disable=SC2086
  "$compiler" "$folder/mutant.o" $others $objects -lginac -lcln -o "$folder/tests" \
    2>"$folder/errors" ||
    { echo "DOES NOT LINK"; return 1; }
  # [source]: reads only files, which are as they were
  timeout "$seconds" "$folder/tests" --abort '~[source]' >/dev/null 2>&1
}
# One mutant: a file, a sed command, what it does.
try() {
  local file=$1 command=$2 what=$3 folder verdict
  folder=$(mktemp -d "$work/XXXXXX")
  sed -e "$command" "$room/$file" >"$folder/$file"
  if cmp -s "$room/$file" "$folder/$file"; then
    echo "CHANGES NOTHING  $file: $what"
  elif verdict=$(survives "$folder" "$file"); then
    echo "SURVIVED  $file: $what"
  elif [ -n "$verdict" ]; then
    echo "$verdict  $file: $what"
  fi
  rm -rf "$folder"
}
export -f survives try

# A mutant of each line of FILE with PATTERN, and not BUT, in it, unless the list has a reason why
# it is equivalent.
guards() {
  local file=${1##*/} number line
  grep -snE "$2" "$1" | grep -v "$3" | while IFS=: read -r number line; do
    line=${line#"${line%%[![:space:]]*}"}
    grep -qF "$file|guard|$line|" "$list" || printf '%s\0%s\0%s\0' "$file" "$number$4" "$line"
  done || true
}
bends() {
  local file command
  while IFS='|' read -r file command; do
    case $file in '' | '#'*) continue ;; esac
    case $command in guard\|*) continue ;; esac
    printf '%s\0%s\0%s\0' "$file" "$command" "$command"
  done <"$list"
}
{
  for path in "$room"/*.cpp; do guards "$path" 'refuse\(' 'void refuse' 's/refuse(/ignore(/'; done
  for path in "$room"/*.cpp; do
    guards "$path" '^ *(check_[a-z_]*|sorts_of)\(.*\);$' '^$' 's/[a-z_]*(.*);/;/'
  done
  # Of names, the reasons why one is none are guards, too.
  guards "$room/names.cpp" 'return (read_as_index|name \+|it->second|"\\"")' 'could be read' \
    's/return .*;/;/'
  bends
} >"$work/mutants"
count=$(($(tr -cd '\0' <"$work/mutants" | wc -c) / 3))
xargs -0 -n 3 -P "$(nproc)" bash -c 'try "$@"' _ <"$work/mutants" | tee "$work/verdicts"
echo "$count mutants, $(wc -l <"$work/verdicts") not turned red"
test ! -s "$work/verdicts"
