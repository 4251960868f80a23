#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Doxygen renders every public header without a warning; and it warns where something is not documented.
#   reference_test.sh DOXYGEN DOXYFILE
set -euo pipefail
doxygen=$1 settings=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
render() { # further settings
  mkdir -p "$scratch/pages"
  { cat "$settings" && echo "OUTPUT_DIRECTORY = $scratch/pages" && printf '%s\n' "$@"; } | "$doxygen" - 2>"$scratch/warnings"
}

render || { cat "$scratch/warnings" && exit 1; }
for page in index namespacemagicmass_1_1fast structmagicmass_1_1generated_1_1Velocities; do
  [[ -s $scratch/pages/$page.html ]] || { echo "no page $page.html" && exit 1; }
done
mkdir "$scratch/planted"
printf '%s\n' 'namespace magicmass { int nobody_says_what(); }' >"$scratch/planted/planted.hpp"
if render "INPUT += $scratch/planted"; then
  echo "a function that is not documented was not noticed"
  exit 1
fi
grep -q 'nobody_says_what.*not documented' "$scratch/warnings"
