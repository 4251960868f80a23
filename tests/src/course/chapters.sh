#!/usr/bin/env bash
# chapters.sh TUTORIALS: each chapter begins with its title, its goal and a figure; TEACHERS.md
# names exercises and chapters that exist. Then the same of copies in which one of these is spoilt:
# each is refused.
# shellcheck disable=SC2016  # backquotes of Markdown
set -euo pipefail
export LC_ALL=C

faults() { # folder
  local intro name
  for intro in "$1"/[0-9]*/intro.md; do
    [[ $(grep -v '^$' "$intro" | head -n 3) == '# '*$'\n## Goal\n{{figure:'* ]] ||
      echo "$intro: no title, goal and figure"
  done
  for name in $(grep -oE '`([a-z]|[0-9]{2}_)[A-Za-z_0-9]*`' "$1/TEACHERS.md" | tr -d '`'); do
    compgen -G "$1/*/exercises/$name.toml" >/dev/null || [[ -d $1/$name ]] ||
      echo "TEACHERS.md: $name is not there"
  done
}

faults "$1" | tee /dev/stderr | (! grep -q .)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
refuses() { # tutorials, what is said, file, edit
  cp -r "$1" "$scratch/all"
  sed -i "$4" "$scratch/all/$3"
  faults "$scratch/all" | grep -q "$2" || { echo "not refused: $4"; exit 1; }
  rm -r "$scratch/all"
}
refuses "$1" 'no title, goal' 02_cycle/intro.md '1s/^# //'
refuses "$1" 'no title, goal' 02_cycle/intro.md 's/^## Goal/## Aim/'
refuses "$1" 'no title, goal' 02_cycle/intro.md 's/^{{figure:/First, words. &/'
refuses "$1" 'half_angel is not' TEACHERS.md 's/`half_angle`/`half_angel`/'
refuses "$1" '02_cycles is not' TEACHERS.md 's/`02_cycle`/`02_cycles`/'
