#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Do the tests find faults? Plants small ones, one at a time, in a copy of this checkout, builds what tells and runs it,
# the quickest first, up to the first failure. An hour for all hundred; needs what `setup` installs, and is
# much slower without ccache.
#   plant_faults.sh [--seed N] [--minutes N] [--only GROUPS] [--tests quick] [--scratch FOLDER] [--faults FILE]
# A line for each fault: found or survived, file:line:column, before -> after, and what told. Then the score.
# A fault that does not compile is none, and the next one takes its place. --faults FILE plants those of lines of an
# earlier output again: those that survived `--tests quick`, say, which leaves out what takes long and finds few. The
# scratch folder stays, so that the next run builds little.
set -euo pipefail
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
seed=8 minutes=600 only='' which=all again='' scratch=$repository/build/mutation
while (($# > 1)); do
  case $1 in
    --seed) seed=$2 ;;
    --minutes) minutes=$2 ;;
    --only) only=" $2 " ;;
    --tests) which=$2 ;;
    --scratch) scratch=$2 ;;
    --faults) again=$(realpath "$2") ;;
    *) break ;;
  esac
  shift 2
done
if (($# > 0)); then
  sed -n '6s/^# *//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi

groups=(derivation kernel passes runtime primitives)
declare -A wanted=([derivation]=25 [kernel]=12 [passes]=25 [runtime]=26 [primitives]=12)
files_of() { # group; what it consists of, from the repository's top
  case $1 in
    derivation) find symbolic/derivation -name '*.cpp' ;;
    kernel) find symbolic/proof -name '*.cpp' ;;
    passes) find symbolic/codegen -name '*.cpp' ;;
    runtime) find src/magicmass/{evaluators,scenes,simulator} src/magicmass/{batch,tiers} -name '*.cpp' -o -path '*/evaluators/*.hpp' -o -path '*/simulator/*.hpp' ;;
    primitives) find src/magicmass/{arithmetic,batch,tiers} -name '*.hpp' -not -name '*_table.hpp' ;;
  esac | LC_ALL=C sort
}

tree=$scratch/tree build=$scratch/tree/build/default log=$scratch/log
tests=$build/tests
mkdir -p "$tree"
export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$repository}
if type -P ccache >/dev/null; then export CMAKE_CXX_COMPILER_LAUNCHER=ccache; fi
cd "$repository"
# What differs alone: a file as old as here would be older than what was built of it with a fault in it.
git ls-files --cached --others --exclude-standard | while read -r file; do
  if [[ ! -e $file ]] || cmp -s "$file" "$tree/$file"; then continue; fi
  mkdir -p "$tree/$(dirname "$file")"
  cp "$file" "$tree/$file"
done
g++ -std=c++20 -O1 "$repository/tests/mutation/faults.cpp" -o "$scratch/faults"
cmake -S "$tree" -B "$build" -DCMAKE_BUILD_TYPE=Release >"$log" 2>&1

# Processor seconds that a check may take: three times what it takes without a fault, and more.
declare -A limit=([generation]=20 [symbolic_tests]=150 [slower_symbolic_tests]=250 [runtime_tests]=30
  [arithmetic_tests]=30 [report_tests]=60 [reference_tests]=90)
by=''
built() { cmake --build "$build" --parallel 2 --target "$@" >"$log" 2>&1; }
passes() { # what it is called, a command line
  local status=0
  { (ulimit -v 8000000 -t "${limit[$1]}" && exec timeout 1800 "${@:2}") >"$log" 2>&1 || status=$?; } 2>/dev/null
  by=$1
  if ((status == 124 || status == 137 || status == 152)); then by="$1, which took too long"; fi
  ((status == 0))
}
generates() {
  rm -rf "$scratch/generated"
  passes generation "$build/bin/magicmass_generator" --out "$scratch/generated" || return 1
  by='other code is generated'
  diff -rq --exclude=CMakeLists.txt "$tree/generated" "$scratch/generated" >"$log" 2>&1
}
slow=(mutation forms_mutation specialised generate chain make_kernel)
except() { printf '~[#%s_test]' "$@"; }
# Catch2's names of the tests in a folder, except the slow ones: what a fault in the folder beside it fails first.
tests_in() { # folder
  local file name
  for file in "$tree/$1"/*_test.cpp; do
    name=$(basename "$file" _test.cpp)
    if [[ -e $file && " ${slow[*]} " != *" $name "* ]]; then echo "$name"; fi
  done
}
# Which program has the tests of a file, or else of its folder.
program_of() { # file below src/magicmass, without its suffix
  local found
  found=$(sed -n "/^ *add_executable/h; \#^ *$1[a-z_]*_test\.cpp#{g;p}" "$tree/tests/src/CMakeLists.txt" |
    sed -n '/magicmass_\(runtime\|arithmetic\|report\|reference\)_tests/{s/.*magicmass_\(.*\)_tests/\1/p;q}')
  if [[ -z $found && $1 == */?* ]]; then found=$(program_of "${1%/*}/"); fi
  echo "${found:-runtime}"
}
steps_for() { # file; sets steps
  local program first folder near
  folder=$(dirname "${1#src/magicmass/}")
  if [[ $1 == symbolic/* ]]; then
    program=$tests/symbolic/magicmass_symbolic_tests
    readarray -t near < <(tests_in "tests/$(cut -d / -f 1-2 <<<"$1")")
    steps=('built magicmass_generator' generates 'built magicmass_symbolic_tests')
    if ((${#near[@]} > 0)); then
      steps+=("passes symbolic_tests $program -# -a $(printf '[#%s_test]~[time],' "${near[@]}")")
    fi
    steps+=("passes symbolic_tests $program -# -a ~[time]$(except "${slow[@]}" "${near[@]}")")
    if [[ $which != quick ]]; then
      steps+=("passes slower_symbolic_tests $program -# -a $(printf '[#%s_test]~[time],' "${slow[@]}")")
    fi
    return
  fi
  first=${1#src/magicmass/} first=$(program_of "${first%.*}")
  readarray -t near < <(tests_in "tests/src/$folder")
  steps=()
  for program in "$first" runtime arithmetic report reference; do
    if [[ " ${steps[*]} " == *"magicmass_${program}_tests "* ]]; then continue; fi
    if [[ $which == quick && $program == re[pf]* && $program != "$first" ]]; then continue; fi
    steps+=("built magicmass_${program}_tests")
    if ((${#near[@]} > 0)); then
      steps+=("passes ${program}_tests $tests/src/magicmass_${program}_tests -# -a $(printf '[#%s_test]~[time],' "${near[@]}")")
    fi
    steps+=("passes ${program}_tests $tests/src/magicmass_${program}_tests -# -a ~[time]$(except "${near[@]}")")
  done
}
# Sets outcome: survived, found, or none where it does not compile.
try() { # file
  local step steps words
  steps_for "$1"
  outcome=survived
  for step in "${steps[@]}"; do
    read -ra words <<<"$step"
    if "${words[@]}"; then continue; fi
    if [[ ${words[0]} == built ]]; then outcome=none; else outcome=found; fi
    return 0
  done
  by="$which tests pass"
}

# Nothing fails without a fault: asked once for each state of the sources, when the first is about to be planted there.
declare -A asked=()
passes_without_a_fault() { # file
  local side=src/magicmass tests_of=tests/src state
  if [[ $1 == symbolic/* ]]; then side=symbolic tests_of=tests/symbolic; fi
  if [[ -n ${asked[$side]-} ]]; then return; fi
  asked[$side]=yes
  state=$(cd "$tree" && find $side $tests_of generated -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum)
  if grep -qsF "$state" "$scratch/states_that_pass"; then return; fi
  try "$1"
  [[ $outcome == survived ]] || { echo "without a fault: $by" && cat "$log" && exit 1; } >&2
  echo "$state" >>"$scratch/states_that_pass"
}

number=0 found=0
plant() { # file, line, column, before, after; status 1 where it was no fault
  passes_without_a_fault "$1"
  local started=$SECONDS
  cp "$tree/$1" "$scratch/as_it_was"
  "$scratch/faults" plant "$tree/$1" "${@:2}"
  try "$1"
  cp "$scratch/as_it_was" "$tree/$1"
  if [[ $outcome == none ]]; then return 1; fi
  number=$((number + 1))
  if [[ $outcome == found ]]; then found=$((found + 1)); fi
  printf '%3d %-8s %s:%s:%s  "%s" -> "%s"  (%s, %s s)\n' "$number" "$outcome" "$@" "$by" "$((SECONDS - started))"
}

if [[ -n $again ]]; then
  pattern='^ *[0-9]+ +(found|survived) +([^ ]+):([0-9]+):([0-9]+)  "(.*)" -> "(.*)"  \('
  while IFS= read -r line <&3; do
    if [[ $line =~ $pattern ]]; then plant "${BASH_REMATCH[@]:2:5}" || echo "no longer compiles: $line"; fi
  done 3<"$again"
else
  declare -A done_in=()
  for group in "${groups[@]}"; do
    done_in[$group]=0
    readarray -t files < <(files_of "$group")
    "$scratch/faults" list "$seed" "${files[@]}" >"$scratch/$group"
  done
  unfinished=yes
  while [[ -n $unfinished ]] && ((SECONDS < 60 * minutes)); do
    unfinished=
    for group in "${groups[@]}"; do # in turn, so that a run cut short has some of each
      if [[ -n $only && $only != *" $group "* ]] || ((done_in[$group] >= wanted[$group])) || [[ ! -s $scratch/$group ]]; then
        continue
      fi
      unfinished=yes
      IFS=$'\x1f' read -r file line column before after < <(head -n 1 "$scratch/$group" | tr '\t' '\037')
      sed -i 1d "$scratch/$group"
      if plant "$file" "$line" "$column" "$before" "$after"; then done_in[$group]=$((done_in[$group] + 1)); fi
    done
  done
fi
echo "$found of $number faults found"
