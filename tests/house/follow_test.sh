#!/usr/bin/env bash
# The page "Follow a_n" in CONTRIBUTING.md: at most 18 files, 5 of them chapters, of the rooms
# between the law and an array of numbers; each is there, and is built or included. A page that is
# spoiled is refused.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
follow() {
  local files file chapters
  local rooms='symbolic/(kernel|algebra|derivation|codegen|generate)|generated'
  mapfile -t files < <(sed -n '/^## Follow a_n/,$s/^| `\([^`]*\)`.*/\1/p')
  ((${#files[@]} >= 10 && ${#files[@]} <= 18)) ||
    { echo "${#files[@]} files, 10 to 18 are allowed"; return 1; }
  chapters=$(printf '%s\n' "${files[@]}" | grep -c '^symbolic/derivation/')
  ((chapters <= 5)) ||
    { echo "$chapters files of the derivation, at most 5 are allowed"; return 1; }
  for file in "${files[@]}"; do
    [[ -f $file ]] || { echo "CONTRIBUTING.md: no file $file"; return 1; }
    [[ $file =~ ^($rooms|src/magicmass/(arithmetic|numbers))/ ]] ||
      { echo "CONTRIBUTING.md: $file is on no way from the law to an array"; return 1; }
    if [[ $file == *.cpp ]]; then
      grep -qw "$(basename "$file")" "$(dirname "$file")/CMakeLists.txt"
    else
      grep -rq --include='*.[ch]pp' "#include \"\(${file#*/}\|${file#src/}\)\"" \
        symbolic src generated
    fi || { echo "CONTRIBUTING.md: nothing builds or includes $file"; return 1; }
  done
}
follow <CONTRIBUTING.md
for spoiled in 's|codegen/terms.cpp|codegen/lost.cpp|' \
  's|symbolic/codegen/terms.cpp|src/report/report.cpp|' \
  '/codegen/d;/magicmass/d' 's|symbolic/kernel/theorem.hpp|symbolic/derivation/unfolded.cpp|'; do
  if sed "$spoiled" CONTRIBUTING.md | follow >/dev/null; then
    echo "not refused: $spoiled"
    exit 1
  fi
done
