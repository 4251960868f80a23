#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The course as a reader gets it: it renders, its links lead somewhere, nothing needs a network or a script, colours have
# contrast in both schemes, and, where Chromium is installed, each page passes page_checks.js at two widths.
# Each check is shown to refuse something spoiled. Status 77: pandoc or gnuplot is missing.
#   pages_test.sh COURSE MAGICMASS PROGRAMS TUTORIALS
set -euo pipefail
course=$1 magicmass=$2 programs=$3 tutorials=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
out=$folder/course

for needed in pandoc gnuplot; do
  if ! type -P $needed >/dev/null; then
    echo "skipped: no $needed (./setup --all installs it)"
    exit 77
  fi
done

fail() {
  echo "FAILED: $*"
  exit 1
}
render() { "$course" --tutorials "$1" --programs "$programs" --magicmass "$magicmass" "${@:2}"; }
refused() { # what it shows, words of the refusal; the tutorials in $folder/tutorials are spoiled
  local said
  if said=$(render "$folder/tutorials" 2>&1); then fail "accepted: $1"; fi
  [[ $said == *"$2"* ]] || fail "$1: said $said"
  echo "refused: $1"
}

render "$tutorials" --out "$out" --no-pdf
readarray -t chapters < <(cd "$tutorials" && ls -d [0-9][0-9]_*)
((${#chapters[@]} == 13)) || fail "${#chapters[@]} chapters"

# reading takes 10 to 20 minutes
for chapter in "${chapters[@]}"; do
  minutes=$(grep -oE 'about [0-9]+ minutes' "$out/$chapter.html" | grep -oE '[0-9]+')
  ((minutes >= 10 && minutes <= 20)) || fail "$chapter takes $minutes minutes"
done

# a text or an output that drifted
cp -r "$tutorials" "$folder/tutorials"
sed -i '0,/everything/s//something/' "$folder/tutorials/06_magic_ratios/expected_output.txt"
refused "an output that changed" "06_magic_ratios/expected_output.txt:3: the program prints"
cp "$tutorials/06_magic_ratios/expected_output.txt" "$folder/tutorials/06_magic_ratios/"
sed -i '0,/{{with_the_laws}}/s//thirty/' "$folder/tutorials/01_contact/intro.md"
refused "a number in words for one that is printed" "01_contact/intro.md: does not use {{with_the_laws}}"
cp "$tutorials/01_contact/intro.md" "$folder/tutorials/01_contact/"
sed -i 's/^## Figure$/## Picture/' "$folder/tutorials/01_contact/intro.md"
refused "a section of another name" "01_contact/intro.md: its sections"

check_links() { # pages: files and anchors exist, nothing comes from a network, no script
  local page target file anchor bad=0
  for page in "$1"/[01]*.html "$1/index.html" "$1/course.html" "$1/derivation.html"; do
    if grep -nE '(src|href)="(https?:)?//|<script|@import' "$page"; then bad=1; fi
    for target in $(grep -oE '(src|href)="[^"]+"' "$page" | cut -d'"' -f2 | sort -u); do
      file=${target%%#*} anchor=${target#"$file"}
      file=$1/${file:-$(basename "$page")}
      if [[ ! -f $file ]]; then
        echo "$(basename "$page"): $target is not there" && bad=1
      elif [[ -n $anchor ]] && ! grep -qF "id=\"${anchor#\#}\"" "$file"; then
        echo "$(basename "$page"): nothing is called $target" && bad=1
      fi
    done
  done
  return $bad
}
check_links "$out" || fail "links"
for page in "${chapters[@]/%/.html}" derivation.html; do
  grep -q 'href="index.html"' "$out/$page" || fail "$page has no way back to the course"
done
mkdir "$folder/spoiled"
cp -r "$out/." "$folder/spoiled"
sed -i 's/href="02_cycle.html"/href="02_circle.html"/' "$folder/spoiled/01_contact.html"
if check_links "$folder/spoiled"; then fail "a link to nowhere was accepted"; fi

# WCAG contrast of all letters on all papers, light and dark
check_colours() { # style sheet
  awk '
    function channel(hex, i,   c) {
      c = (index("0123456789abcdef", substr(hex, i, 1)) - 1) * 16 + index("0123456789abcdef", substr(hex, i + 1, 1)) - 1
      c /= 255
      return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ^ 2.4
    }
    function luminance(hex) { return 0.2126 * channel(hex, 1) + 0.7152 * channel(hex, 3) + 0.0722 * channel(hex, 5) }
    function ratio(x, y) { return x > y ? (x + 0.05) / (y + 0.05) : (y + 0.05) / (x + 0.05) }
    /:root/ { scheme++ }
    { rest = $0
      while (match(rest, /--[a-z]+: #[0-9a-f]{6}/) || match(rest, /--[a-z]+: #[0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f][0-9a-f]/)) {
        split(substr(rest, RSTART + 2, RLENGTH - 2), part, ": #")
        colour[scheme, part[1]] = luminance(part[2])
        rest = substr(rest, RSTART + RLENGTH)
      } }
    END {
      letters = split("ink quiet link good keyword string", letter, " ")
      split("paper box", sheet, " ")
      for (s = 2; s <= 3; s++) for (i = 1; i <= letters; i++) for (j = 1; j <= 2; j++) {
        if (!((s - 1, letter[i]) in colour)) { print "no colour", letter[i]; bad = 1; continue }
        r = ratio(colour[s - 1, letter[i]], colour[s - 1, sheet[j]])
        if (r < 4.5) { printf "contrast of %s on %s: %.2f\n", letter[i], sheet[j], r; bad = 1 }
      }
      exit bad
    }' "$1"
}
check_colours "$out/course.css" || fail "contrast"
sed 's/--quiet: #57606a/--quiet: #97a0aa/' "$out/course.css" >"$folder/pale.css"
if check_colours "$folder/pale.css" >/dev/null; then fail "pale letters were accepted"; fi

if ! type -P chromium >/dev/null; then
  echo "pages not looked at in a browser: no chromium (./setup --all installs it)"
  exit 0
fi

verdicts() { # folder, light or dark, pages: what page_checks.js says of each, on a desk and on a phone
  local page scheme=$((${2/light/1}))
  cp "$here/page_checks.js" "$1"
  {
    echo '<!DOCTYPE html><title>checks</title><body><ol></ol><script>addEventListener("message", (e) => {'
    echo 'const li = document.createElement("li"); li.textContent = e.data; document.querySelector("ol").append(li); });</script>'
    for page in "${@:3}"; do
      sed 's|</body>|<script src="page_checks.js"></script></body>|' "$1/$page" >"$1/checked_$page"
      for width in 390 1100; do echo "<iframe width=$width height=800 src=\"checked_$page\"></iframe>"; done
    done
  } >"$1/checks.html"
  chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=30000 \
    --blink-settings=preferredColorScheme=$scheme --dump-dom "file://$1/checks.html" 2>/dev/null |
    grep -oE '<li>[^<]*' | sed 's/^<li>//'
}
dark=0
pages=(index.html "${chapters[@]/%/.html}")
for scheme in light dark; do
  verdicts "$out" $scheme "${pages[@]}" >"$folder/said"
  grep -v ': good$' "$folder/said" && fail "pages in the $scheme scheme"
  (($(wc -l <"$folder/said") == 2 * ${#pages[@]})) || fail "$(wc -l <"$folder/said") pages of ${#pages[@]} answered"
done
sed -i 's/--quiet: #57606a/--quiet: #97a0aa/; s/\[tabindex\]:focus-visible/.nothing/' "$folder/spoiled/course.css"
sed -i 's/ tabindex="0"//' "$folder/spoiled/06_magic_ratios.html"
verdicts "$folder/spoiled" light 06_magic_ratios.html >"$folder/said"
grep -q 'contrast [1-4]' "$folder/said" || fail "the browser saw no pale letters"
grep -q 'not with the keyboard' "$folder/said" || fail "the browser saw nothing that cannot be scrolled"
echo "all pages are good, on a desk and on a phone, light and dark"
