#!/usr/bin/env bash
# The rules of the house, for the checkout in a folder: house.sh FOLDER. Prints the table of rooms;
# a broken rule is a line "FILE:LINE: what" or "ROOM: what" and exit code 1.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
cd "${1:-$here/../..}"
export LC_ALL=C
broken=$(mktemp)
trap 'rm -f "$broken"' EXIT
rooms() { grep -v '^#' "$here/rooms.txt"; }
packages() { grep -v '^#' "$here/packages.txt"; }
files() {
  find . -type f \( -path './.git' -o -path './.git/*' -o -path './build*/*' \) -prune \
    -o -type f -printf '%P\n' | sort
}
mapfile -t all < <(files)
of() { printf '%s\n' "${all[@]}" | grep -E "$1" || true; }
mapfile -t code < <(of '\.(cpp|hpp)$')

# 1. Each C++ file belongs to a room; each room keeps its budget, and so does the house.
grep -Hcv '^[[:space:]]*$' "${code[@]}" | awk '
  NR == FNR {rooms[$1]; next}
  {
    best = ""  # the longest room that the file is in
    for (r in rooms) if (index($1, r "/") == 1 && length(r) > length(best)) best = r
    print best, $2, $1
  }' <(rooms) FS=: - >"$broken.lines"
awk 'NF == 2 {print $2 ": is in no room of tests/house/rooms.txt"}' "$broken.lines" >>"$broken"
printf '%-28s %7s %7s %7s %6s\n' room lines ceiling goal files
rooms | while read -r room budget goal _; do
  read -r lines count < <(
    awk -v r="$room" '$1 == r {n += $2; ++f} END {print n + 0, f + 0}' "$broken.lines")
  printf '%-28s %7d %7d %7d %6d%s\n' "$room" "$lines" "$budget" "$goal" "$count" \
    "$( ((lines <= goal)) || echo '  above its goal')"
  ((lines <= budget)) || echo "$room: $lines lines, at most $budget are allowed" >>"$broken"
done
awk -v broken="$broken" -v most=38000 'NF == 3 {n += $2; ++f} END {
  printf "%-28s %7d %7d %7d %6d\n", "all", n, most, most, f
  if (n > most) print "all: " n " lines, at most " most " are allowed" >>broken}' "$broken.lines"
rm -f "$broken.lines"

# 2. Lines: at most 100 columns (characters, not bytes) but in tables and pictures of Markdown, one
# statement each.
mapfile -t scripts < <(of '(\.sh|\.gp|\.cmake|^setup|^\.ci/run)$')
mapfile -t texts < <(of '(CMakeLists\.txt|cmake\.in|\.md|\.v|\.css)$')
LC_ALL=C.UTF-8 grep -aHnE '^.{101}' "${code[@]}" "${scripts[@]}" "${texts[@]}" |
  grep -vE '^[^:]*\.md:[0-9]+:(\||!\[)' |
  sed -E 's/^([^:]*:[0-9]+):.*/\1: more than 100 columns/' >>"$broken" || true
awk '
    {
      gsub(/\\./, ""); gsub(/\x27.\x27/, "0"); gsub(/"[^"]*"/, "\"\""); sub(/\/\/.*/, "")
      heads = $0
      while (gsub(/for \([^()]*\)|\([^();{}]*\)/, "@", heads)) {}
      two = heads ~ /;[ \t]*\}[ \t]*else|\{[^{}]*;[ \t]*[^ \t{};][^{}]*\}/ ||
        heads ~ /^[ \t]*[a-z_:.]+@, [a-z_:.]+@;$/
      while (gsub(/\([^()]*\)/, "")) {}
      if (two || ($0 !~ /(^|[^a-z_])(for|if) \(/ && $0 ~ /;[ \t]*[^ \t})]/))
        print FILENAME ":" FNR ": two statements on a line"
    }' "${code[@]}" >>"$broken"

# 3. C++ has the endings .cpp and .hpp; scripts are few.
endings='cpp|hpp|pc\.in|cmake\.in|md|txt|toml|tsv|csv|json|sh|gp|v|svg|css|supp'
printf '%s\n' "${all[@]}" | grep -vE "\.($endings)$" |
  grep -vE '(^|/)(setup|\.ci/run|LICENSE|\.git|\.gitignore|\.clang-(format|tidy))$' |
  sed 's/$/: this ending is not allowed (C++ is .cpp, .hpp; scripts are bash)/' >>"$broken" || true
# Tables of answers and attacks, and exercises, hold students' programs: .tsv and .toml.
types='(int|void|double|bool|auto|std::[a-z_]+)'
declared="((inline|static|constexpr|const) )*$types [A-Za-z_]+ ?[(;={]"
of '^(symbolic|src|generated|tests|examples)/.*\.(txt|csv|json|md)$' |
  { grep -v '/sessions/' || true; } |
  xargs -r grep -HnE "^[ \t]*(#[ \t]*include|namespace [a-z]|template ?<|$declared)" |
  sed -E 's/^([^:]*:[0-9]+):.*/\1: C++ in a text/' >>"$broken" || true
lines=$(cat "${scripts[@]}" | grep -cv '^[[:space:]]*$')
printf '%-28s %7d %7d %7d %6d\n' scripts "$lines" 1500 1500 "${#scripts[@]}"
((lines <= 1500)) || echo "scripts: $lines lines, at most 1500 are allowed" >>"$broken"

# 4. Arrows: what a room includes, it may see; what is included or found is in setup's plain list.
plain=$(sed -n '/^packages=(/,/^)/{s/#.*//;p}' setup)
awk '
  function room_of(path, r, best) {
    for (r in sees) if (index(path, r "/") == 1 && length(r) > length(best)) best = r
    return best
  }
  function allowed(what, i, n, parts) {
    n = split(sees[room], parts, " ")
    for (i = 1; i <= n; ++i) {
      if (parts[i] == what) return 1
      if (parts[i] ~ /\*$/ && index(what, substr(parts[i], 1, length(parts[i]) - 1)) == 1) return 1
    }
    return 0
  }
  FILENAME ~ /rooms\.txt$/ {
    if ($1 != "#") {
      line = ""
      for (i = 4; i <= NF; ++i) line = line " " $i
      sees[$1] = line
    }
    next
  }
  FILENAME ~ /packages\.txt$/ { if ($1 != "#" && $2 != "-") package[$2] = $1; next }
  BEGIN { roots = split("symbolic/ src/ generated/ tests/", root, " ") }
  FNR == 1 {
    room = room_of(FILENAME)
    if (!known) {
      for (i = 1; i < ARGC; ++i) is_file[ARGV[i]] = 1
      known = 1
    }
  }
  /^[ \t]*#[ \t]*include[ \t]*["<]/ {
    split($0, quoted, /["<>]/)
    if (quoted[2] ~ /\.\./) print FILENAME ":" FNR ": .. in an include"
    to = ""
    for (i = 1; i <= roots; ++i) if (root[i] quoted[2] in is_file) to = room_of(root[i] quoted[2])
    if (to != "" && to != room && room != "" && !allowed(to))
      print FILENAME ":" FNR ": " room " may not see " to
    beside = FILENAME
    sub(/[^\/]*$/, quoted[2], beside)
    if (to == "" && /include[ \t]*"/ && !(beside in is_file) && !/_files\.txt"/)
      print FILENAME ":" FNR ": " quoted[2] " is no file of ours: include it as <" quoted[2] ">"
    for (p in package) if (index(quoted[2], p) == 1 && room != "" && !allowed(package[p]))
      print FILENAME ":" FNR ": " room " may not see " package[p]
  }' "$here/rooms.txt" "$here/packages.txt" "${code[@]}" >>"$broken"
# What CMake looks for, a name a line: find_package(NAME ...), pkg_check_modules(PREFIX options
# NAME...).
looked_for=$(cat $(of '(CMakeLists.txt|cmake.in)$') | sed 's/#.*//' | tr '\n' ' ' |
  grep -oiE '(find_(package|dependency|library|path)|pkg_[a-z]+_modules?)[ \t]*\([^)]*' |
  sed -E 's/[ \t]*\([ \t]*/ /' | awk '{
    if (tolower($1) !~ /^pkg_/) {print $2; next}
    for (i = 3; i <= NF; ++i) if ($i !~ /^[A-Z_]+$/) print $i}' | grep -vx magicmass | sort -u)
included=$(sed -nE 's/^[ \t]*#[ \t]*include[ \t]*<([^>]*)>.*/\1/p' "${code[@]}" |
  grep '[/.]' | sort -u || true)
packages | while read -r _ include found debian; do
  if grep -qx -- "$found" <<<"$looked_for" ||
    { [[ $include != - ]] && grep -q "^$include" <<<"$included"; }; then
    grep -qwF -- "$debian" <<<"$plain" || echo "setup: the plain list lacks $debian" >>"$broken"
  fi
done
for found in $looked_for; do
  packages | awk -v f="$found" '$3 == f {ok = 1} END {exit !ok}' ||
    echo "tests/house/packages.txt: lacks the package that CMake finds as $found" >>"$broken"
done
for include in $included; do
  packages | awk -v i="$include" '$2 != "-" && index(i, $2) == 1 {ok = 1} END {exit !ok}' ||
    case $include in
      immintrin.h | arm_neon.h | wasm_simd128.h) ;;
      unistd.h | sys/* | fcntl.h | poll.h | signal.h | spawn.h) ;;
      *) echo "tests/house/packages.txt: lacks the package of <$include>" >>"$broken" ;;
    esac
done

# One file knows a processor.
grep -lE '__AVX|__builtin_cpu|immintrin|__ARM|__aarch64' "${code[@]}" |
  grep -v '^tests/\|/arithmetic/simd.hpp$' |
  sed 's/$/: names a processor, which simd.hpp alone may/' >>"$broken" || true

# The files that tests/cycle.sh edits are there.
if [[ -f tests/cycle.sh ]]; then
  sed -n 's/^edited \([^ ]*\) .*/\1/p' tests/cycle.sh | while read -r file; do
    [[ -f $file ]] || echo "tests/cycle.sh: no file $file" >>"$broken"
  done
fi

# What may travel alone says its licence; REUSE.toml says that of all others.
of '^(generated|src/magicmass/(arithmetic|numbers|simulator)|examples)/.*\.[ch]pp$' |
  while read -r file; do
    [[ $(head -n 1 "$file") == "// "*"SPDX-License-Identifier: MIT" ]] ||
      echo "$file:1: is under MIT and does not say so" >>"$broken"
  done

# 5. Files are as the committed .clang-format prints them, where that clang-format is.
if [[ ${2-} == format ]]; then
  clang-format --dry-run --Werror "${code[@]}" 2>&1 | grep 'error:' |
    sed 's/error: .*/not as .clang-format prints it/' >>"$broken" || true
fi

cat "$broken" >&2
[[ ! -s $broken ]]
