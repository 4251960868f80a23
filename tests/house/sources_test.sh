#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The rules of CONTRIBUTING.md that a script can check, over every source file that git does not ignore.
# Before that it shows on small planted trees that each check passes a good tree and refuses a bad one.
#   sources_test.sh          both, on this repository
#   sources_test.sh FOLDER   the checks alone, on FOLDER
set -euo pipefail
this=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/$(basename "${BASH_SOURCE[0]}")
repository=${this%/tests/house/*}

longest=300
may_be_longer=() # files, each with its reason in a comment

# What each part of the tree may include besides itself. `library`: neither GiNaC, CLN nor the standard library.
declare -A may_include=(
  [proof]='errors ginac cln library'
  [algebraic]='errors ginac cln library'
  [derivation]='proof errors ginac cln library'
  [codegen]='proof errors ginac cln library'
  [render]='proof derivation errors ginac cln library'
  [arithmetic]='library'
  [generated]='arithmetic'
  [errors]='library'
  [runtime]='arithmetic generated errors library'
  [reference]='runtime errors cln library'
  [equality]='algebraic proof derivation errors ginac cln library'
  [course]='proof derivation render library'
  [exercise]='generated'
  [tutorial]='proof derivation codegen generated errors runtime reference ginac cln library'
  [report]='generated errors runtime reference cln library'
  [command]='algebraic proof derivation equality codegen render generated errors runtime reference report ginac cln library'
  [command-header]='algebraic proof derivation equality codegen render generated errors runtime reference report cln library'
)

part_of() { # file of the repository
  case $1 in
    symbolic/*/*) part=${1#symbolic/} part=${part%%/*} ;;
    generated/*) part=generated ;;
    src/magicmass/arithmetic/*) part=arithmetic ;;
    src/magicmass/errors.hpp) part=errors ;;
    src/magicmass/reference/*) part=reference ;;
    src/magicmass/*) part=runtime ;;
    src/report/*) part=report ;;
    src/command/*.hpp | src/command/*.h) part=command-header ;;
    src/command/*) part="command" ;;
    tutorials/course/*) part=course ;;
    tutorials/*/tutorial.cpp) part=tutorial ;;
    tutorials/*/exercises/* | tutorials/exercise_driver.hpp) part=exercise ;;
    *) part=other ;;
  esac
}

find_included() { # file, path in its #include; leaves found, a file of the repository, or nothing
  local folder here=.
  if [[ $1 == */* ]]; then here=${1%/*}; fi
  for folder in "$here" src generated symbolic tutorials .; do
    found=$folder/$2
    if [[ -f $found ]]; then
      if [[ $found == *./* ]]; then found=$(realpath --relative-to=. "$found"); fi
      return
    fi
  done
  found=
}

includes_of() { sed -nE 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*[<"]([^>"]+)[>"].*/\1/p' "$1"; }

complain() { # file, what is wrong
  complaints=$((complaints + 1))
  echo "$1: $2"
}

check_licence() {
  local declared line licence=GPL-2.0-or-later
  case $1 in
    src/magicmass/reference/*) ;;
    src/magicmass/*.[ch]pp | generated/magicmass/*.[ch]pp | examples/*.cpp) licence=MIT ;;
    *CMakeLists.txt) licence=any ;;
  esac
  declared=
  for line in "${content[@]:0:3}"; do
    if [[ $line =~ SPDX-License-Identifier:\ *([A-Za-z0-9.-]+) ]]; then declared=${BASH_REMATCH[1]}; fi
  done
  if [[ -z $declared ]]; then
    complain "$1" "no SPDX line in the first three lines"
  elif [[ $licence != any && $declared != "$licence" ]]; then
    complain "$1" "says $declared where LICENSE says $licence"
  fi
}

check_length() {
  local lines=${#content[@]}
  if [[ $1 =~ ^(symbolic|src|tests|tutorials)/ && " ${may_be_longer[*]-} " != *" $1 "* ]] && ((lines > longest)); then
    complain "$1" "has $lines lines, over $longest: it asks to be two files"
  fi
}

check_name() {
  local name vague="util|utils|utility|utilities|helpers?|misc|managers?"
  for name in ${1//\// }; do
    # common_subexpressions is a fine name; common and numeric_common are not.
    if [[ ${name%%.*} =~ (^|_)($vague)(_|$)|(^|_)common$|(Util|Helper|Misc|Manager)s?$ ]]; then
      complain "$1" "'$name' does not say what is in it"
    fi
  done
}

check_using_namespace() {
  if [[ $1 =~ \.(hpp|h)$ ]] && grep -qE '^[[:space:]]*using[[:space:]]+namespace[[:space:]]' "$1"; then
    complain "$1" "using namespace in a header"
  fi
}

check_includes() {
  local part from path
  part_of "$1" && from=$part
  if [[ -z ${may_include[$from]+known} ]]; then return; fi
  for path in $(includes_of "$1"); do
    find_included "$1" "$path"
    if [[ $path == Eigen/* && $1 != src/magicmass/eigen.hpp ]]; then
      complain "$1" "Eigen is for src/magicmass/eigen.hpp alone: $path"
    fi
    case $path in
      ginac/* | ginac.h) part=ginac ;;
      cln/*) part=cln ;;
      program_before.hpp) part=exercise ;; # written beside the driver of an exercise on passes
      *) if [[ -n $found ]]; then part_of "$found"; elif [[ $path == *[./]* ]]; then part=library; else continue; fi ;;
    esac
    if [[ ${part%-header} != "${from%-header}" && " ${may_include[$from]} " != *" ${part%-header} "* ]]; then
      complain "$1" "$from may not include $part: $path"
    fi
  done
}

# An oracle that shares a formula cannot expose it, so not even by way of another header.
check_reference_is_independent() { # files of reference
  local queue=("$@") path
  local -A seen=()
  while ((${#queue[@]})); do
    local file=${queue[0]}
    queue=("${queue[@]:1}")
    for path in $(includes_of "$file"); do
      find_included "$file" "$path"
      if [[ -z $found || -n ${seen[$found]-} ]]; then continue; fi
      seen[$found]=yes
      if [[ $found == generated/* ]]; then
        complain "$file" "leads from reference to generated code: $path"
      else
        queue+=("$found")
      fi
    done
  done
}

source_files() {
  if [[ -e .git ]]; then
    git ls-files --cached --others --exclude-standard
  else
    find . -type f -not -path './build*' | sed 's|^\./||'
  fi | grep -E '\.(cpp|hpp|h|cmake|sh)$|(^|/)CMakeLists\.txt$|^setup$|^\.ci/run$' | LC_ALL=C sort
}

check_tree() ( # folder; status 1 after complaints
  cd "$1"
  complaints=0 reference=()
  readarray -t files < <(source_files)
  for file in "${files[@]}"; do
    if [[ ! -f $file ]]; then continue; fi # deleted, and git does not know yet
    readarray -t content <"$file"
    for check in licence length name using_namespace includes; do "check_$check" "$file"; done
    if [[ $file == src/magicmass/reference/* ]]; then reference+=("$file"); fi
  done
  check_reference_is_independent ${reference[@]+"${reference[@]}"}
  if ((${#files[@]} == 0)); then complain "$1" "no source files found"; fi
  if ((complaints)); then return 1; fi
  echo "${#files[@]} source files keep the rules"
)

if (($# > 0)); then
  check_tree "$1"
  exit
fi

planted=$(mktemp -d)
trap 'rm -rf "$planted"' EXIT
failures=0

plant() { # file, licence, further lines
  mkdir -p "$(dirname "$planted/$1")"
  printf '%s\n' "// SPDX-License-Identifier: $2" "${@:3}" >"$planted/$1"
}

good_tree() {
  rm -rf "${planted:?}"/*
  plant setup GPL-2.0-or-later
  plant symbolic/proof/kernel.hpp GPL-2.0-or-later '#include <ginac/ginac.h>' '#include <vector>' '#include "magicmass/errors.hpp"'
  plant symbolic/derivation/contact.hpp GPL-2.0-or-later '#include "proof/kernel.hpp"'
  plant symbolic/codegen/passes/common_subexpressions.cpp GPL-2.0-or-later '#include "proof/kernel.hpp"'
  plant generated/magicmass/velocities.hpp MIT '#include <cmath>'
  plant src/magicmass/errors.hpp MIT '#include <stdexcept>'
  plant src/magicmass/terminal.hpp MIT
  plant src/magicmass/scenes/scene.cpp MIT '#include <toml++/toml.h>' '#include "magicmass/errors.hpp"'
  plant src/magicmass/eigen.hpp MIT '#include <Eigen/Core>'
  plant src/magicmass/evaluators/fast.hpp MIT '#include "magicmass/velocities.hpp"'
  plant src/magicmass/reference/exact.hpp GPL-2.0-or-later '#include <cln/cln.h>' '#include "magicmass/errors.hpp"'
  plant src/report/oracle.hpp GPL-2.0-or-later
  plant src/report/errors.cpp GPL-2.0-or-later '#include "magicmass/reference/exact.hpp"' '#include "magicmass/velocities.hpp"'
  plant src/command/derive.cpp GPL-2.0-or-later '#include <ginac/ginac.h>' '#include "derivation/contact.hpp"'
  plant tests/src/fast_test.cpp GPL-2.0-or-later '#include "magicmass/reference/exact.hpp"' 'using namespace std;'
}

expect() { # what this shows, complaint expected or nothing
  local said
  said=$(check_tree "$planted") && said=
  if [[ $said == "$2" ]]; then
    echo "passed: $1"
  else
    failures=$((failures + 1))
    printf 'FAILED: %s\n  expected: %s\n  got:      %s\n' "$1" "$2" "$said"
  fi
}

refused() { # complaint; and as for plant, one bad file in a good tree
  good_tree
  plant "${@:2}"
  expect "refused: $1" "$2: $1"
}

good_tree
expect "a good tree" ""

gpl=GPL-2.0-or-later
refused "no SPDX line in the first three lines" symbolic/proof/rules.cpp '' '' '' "// SPDX-License-Identifier: $gpl"
refused "no SPDX line in the first three lines" setup ''
refused "no SPDX line in the first three lines" tests/CMakeLists.txt ''
refused "says $gpl where LICENSE says MIT" generated/magicmass/counts.hpp $gpl
refused "says MIT where LICENSE says $gpl" src/magicmass/reference/digits.cpp MIT
readarray -t lines < <(seq 1 $longest)
refused "has 301 lines, over 300: it asks to be two files" symbolic/proof/rules.cpp $gpl "${lines[@]}"
refused "'helpers.hpp' does not say what is in it" src/command/helpers.hpp $gpl
refused "'string_utils.cpp' does not say what is in it" symbolic/codegen/string_utils.cpp $gpl
refused "'common' does not say what is in it" tests/common/numbers.cpp $gpl
refused "'SceneManager' does not say what is in it" src/command/SceneManager/scene.cpp $gpl
refused "using namespace in a header" src/command/eval.hpp $gpl '  using namespace std;'
refused "proof may not include derivation: derivation/contact.hpp" symbolic/proof/rules.cpp $gpl '#include "derivation/contact.hpp"'
refused "codegen may not include derivation: ../derivation/contact.hpp" symbolic/codegen/ir.hpp $gpl '#include "../derivation/contact.hpp"'
refused "equality may not include runtime: magicmass/terminal.hpp" symbolic/equality/decide.cpp $gpl '#include "magicmass/terminal.hpp"'
refused "algebraic may not include proof: proof/kernel.hpp" symbolic/algebraic/constant.cpp $gpl '#include "proof/kernel.hpp"'
refused "proof may not include runtime: magicmass/terminal.hpp" symbolic/proof/rules.cpp $gpl '#include <magicmass/terminal.hpp>'
refused "runtime may not include proof: proof/kernel.hpp" src/magicmass/evaluators/slow.hpp MIT '#include "proof/kernel.hpp"'
refused "runtime may not include cln: cln/cln.h" src/magicmass/evaluators/slow.hpp MIT '#  include <cln/cln.h>'
refused "runtime may not include ginac: ginac/ginac.h" src/magicmass/scenes/ratio.cpp MIT '#include <ginac/ginac.h>'
refused "runtime may not include reference: magicmass/reference/exact.hpp" src/magicmass/scenes/ratio.cpp MIT '#include "magicmass/reference/exact.hpp"'
refused "Eigen is for src/magicmass/eigen.hpp alone: Eigen/Core" src/magicmass/batch.hpp MIT '#include <Eigen/Core>'
refused "reference may not include ginac: ginac/ginac.h" src/magicmass/reference/digits.cpp $gpl '#include <ginac/ginac.h>'
refused "report may not include ginac: ginac/ginac.h" src/report/contestants.cpp $gpl '#include <ginac/ginac.h>'
refused "report may not include proof: proof/kernel.hpp" src/report/contestants.cpp $gpl '#include "proof/kernel.hpp"'
refused "reference may not include report: report/oracle.hpp" src/magicmass/reference/digits.cpp $gpl '#include "report/oracle.hpp"'
refused "command-header may not include ginac: ginac/ginac.h" src/command/derive.hpp $gpl '#include <ginac/ginac.h>'
refused "generated may not include library: fmt/core.h" generated/magicmass/counts.hpp MIT '#include <fmt/core.h>'
refused "generated may not include errors: magicmass/errors.hpp" generated/magicmass/counts.hpp MIT '#include "magicmass/errors.hpp"'

refused "course may not include ginac: ginac/ginac.h" tutorials/course/pages.cpp $gpl '#include <ginac/ginac.h>'
refused "exercise may not include runtime: magicmass/terminal.hpp" tutorials/01_contact/exercises/collide/driver.cpp $gpl '#include "magicmass/terminal.hpp"'
refused "tutorial may not include report: report/oracle.hpp" tutorials/01_contact/tutorial.cpp $gpl '#include "report/oracle.hpp"'

good_tree
plant src/magicmass/reference/digits.cpp $gpl '#include "magicmass/evaluators/fast.hpp"'
expect "refused: reference reaching generated code through another header" \
  "src/magicmass/evaluators/fast.hpp: leads from reference to generated code: magicmass/velocities.hpp"

check_tree "$repository" || failures=$((failures + 1))
((failures == 0))
