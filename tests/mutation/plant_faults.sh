#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Do the tests find faults? Plants small ones, one at a time, in a copy of this checkout, builds what tells and runs it,
# the quickest first, up to the first failure. An hour or two for all hundred; needs what `setup` installs, and is
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
git ls-files --cached --others --exclude-standard | while read -r file; do [[ ! -e $file ]] || echo "$file"; done |
  tar -c -T - | tar -x -C "$tree"
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
quick='~[time]~[#mutation_test]~[#forms_mutation_test]~[#specialised_test]~[#generate_test]~[#chain_test]~[#make_kernel_test]'
symbolic_steps=(
  'built magicmass_generator' generates 'built magicmass_symbolic_tests'
  "passes symbolic_tests $tests/symbolic/magicmass_symbolic_tests -# -a $quick"
  "passes slower_symbolic_tests $tests/symbolic/magicmass_symbolic_tests -# -a [#mutation_test]~[time],[#forms_mutation_test]~[time],[#specialised_test]~[time],[#generate_test]~[time],[#chain_test]~[time],[#make_kernel_test]~[time]")
runtime_steps=('built magicmass_runtime_tests' "passes runtime_tests $tests/src/magicmass_runtime_tests -a ~[time]")
for name in arithmetic report reference; do
  runtime_steps+=("built magicmass_${name}_tests" "passes ${name}_tests $tests/src/magicmass_${name}_tests -a ~[time]")
done
if [[ $which == quick ]]; then unset 'symbolic_steps[-1]' 'runtime_steps[-1]' 'runtime_steps[-1]'; fi
# Sets outcome: survived, found, or none where it does not compile.
try() { # file
  local step steps=("${runtime_steps[@]}") words
  if [[ $1 == symbolic/* ]]; then steps=("${symbolic_steps[@]}"); fi
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
