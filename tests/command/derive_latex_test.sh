#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The LaTeX of the derivation compiles, and nothing in it runs off the page. Status 77: no pdflatex here.
#   derive_latex_test.sh PROGRAM
set -euo pipefail
program=$1
slack=2 # points that nobody sees

if ! type -P pdflatex >/dev/null; then
  echo "skipped: no pdflatex (./setup --all installs it)"
  exit 77
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

check_log() { # log; complains of what TeX complained of
  awk -v slack=$slack '
    /^!/ { print; bad = 1 }
    /^Overfull/ && match($0, /\([0-9.]+pt too/) && substr($0, RSTART + 1) + 0 > slack { print; bad = 1 }
    END { exit bad }' "$1"
}

compile() { # name, arguments of derive
  "$program" derive "${@:2}" --format latex -o "$folder/$1.tex"
  for _ in 1 2; do
    (cd "$folder" && pdflatex -interaction=nonstopmode -halt-on-error "$1.tex" >"$1.said" 2>&1) || {
      tail -n 20 "$folder/$1.said"
      return 1
    }
  done
  check_log "$folder/$1.log"
  echo "passed: derive ${*:2}: $(sed -nE 's/^Output written.*\((.*)\).*/\1/p' "$folder/$1.log")"
}

compile whole
compile tree --from c_n
compile step power.a

# the check itself: a line that is too long is seen
printf '%s\n' '\documentclass{article}\begin{document}\noindent\hbox to 40cm{x}\end{document}' >"$folder/wide.tex"
(cd "$folder" && pdflatex -interaction=nonstopmode wide.tex >wide.said 2>&1)
if check_log "$folder/wide.log" >/dev/null; then
  echo "FAILED: a box that is too wide was not seen"
  exit 1
fi
