#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# What goes wrong around a program: it is right all the same or says so in one line, and leaves nothing half-written.
#   faults_test.sh PROGRAM SOURCES
set -euo pipefail
program=$1 sources=$2
scratch=$(mktemp -d)
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT
# shellcheck source=tests/command/fault_checks.sh
source "$sources/tests/command/fault_checks.sh"
fine() { [[ $status == 0 && ! -s $scratch/errors ]]; }
is_empty() { [[ -z $(ls -A "$1") ]]; }
only_missing() { # folder: what is there has the committed bytes
  local wrong
  wrong=$({ diff -rq --exclude='*.part-*' "$sources/generated" "$1" || true; } | grep -v "^Only in $sources/generated") || true
  [[ -z $wrong ]]
}
no_part_files() { [[ -z $(find "$1" -name '*.part-*') ]]; }

# These checks can fail.
for bad in 'exit 0' 'exit 2' 'echo "magicmass: x"$'"'\\n'"'y >&2; exit 2'; do
  run bash -c "$bad"
  check "'$bad' is no refusal" not refused
done
run bash -c 'echo note >&2'
check "words on stderr are not fine" not fine
mkdir "$scratch/half" && touch "$scratch/half/CMakeLists.txt"
check "a half-written file is found" not only_missing "$scratch/half"

# A full disk. Each command's output is small, so that nothing is written before the last moment.
commands=("count --alpha 0.1" "eval --alpha 1/7 --n 2 --format json" "terminal --alpha 0.12 --format csv"
  "ratios --count 5" "simulate $scene" "plan $scene" "equal x x" "doctor" "manual" "derive contact"
  "figure terminal --format csv" "animate $scene" "--help" "--version")
for line in "${commands[@]}"; do
  read -ra words <<<"$line"
  status=0
  "$program" "${words[@]}" >/dev/full 2>"$scratch/errors" || status=$?
  check "disk full: ${words[0]}" refused
done

# A disk with little room, where a mount of our own is possible.
if unshare -rm true 2>/dev/null; then
  mkdir "$scratch/small"
  # shellcheck disable=SC2016
  run unshare -rm bash -c 'mount -t tmpfs -o size=64k none "$1" || exit 77
    "$2" ratios --count 5000 -o "$1/ratios"; code=$?
    [[ -z $(ls -A "$1") ]] || echo "left: $(ls -A "$1")" >&2
    exit $code' - "$scratch/small" "$program"
  [[ $status == 77 ]] || check "disk full half-way: no part of the file is left" refused
fi

# A folder that is not ours to write (root may write anywhere, so a file system that never can).
for place in /proc/nothing /sys/nothing; do
  run "$program" count --alpha 0.1 -o "$place"
  check "read-only folder: -o" refused
  run "$program" generate --out "$place"
  check "read-only folder: generate" refused
  run "$program" manual --man "$place"
  check "read-only folder: manual" refused
done
if ((UID != 0)); then
  mkdir "$scratch/locked" && chmod a-w "$scratch/locked"
  run "$program" generate --out "$scratch/locked"
  check "folder without the right to write: generate" refused
  check "folder without the right to write: left as it was" is_empty "$scratch/locked"
fi

# A reader that goes away.
for line in "${commands[@]:0:4}"; do
  read -ra words <<<"$line"
  status=0
  { "$program" "${words[@]}" 2>"$scratch/errors" || echo $? >"$scratch/status"; } | true
  check "closed pipe: ${words[0]}" test ! -s "$scratch/errors"
  check "closed pipe: ${words[0]} ends well" test ! -e "$scratch/status"
done

# Killed at every stage: what is at the file's name is whole or not there.
"$program" ratios --count 20000 -o "$scratch/whole"
for delay in 0.01 0.03 0.06 0.1 0.2; do
  rm -rf "$scratch/killed" && mkdir "$scratch/killed"
  "$program" ratios --count 20000 -o "$scratch/killed/ratios" &
  sleep "$delay"
  kill -KILL $! 2>/dev/null || true
  wait $! 2>/dev/null || true
  if [[ -e $scratch/killed/ratios ]]; then
    check "killed after $delay s: the file is whole" cmp "$scratch/whole" "$scratch/killed/ratios"
  else
    echo "passed: killed after $delay s: no file"
  fi
done

# Killed as soon as generated files appear beside their names; then two that generate into that folder at once.
both=$scratch/both
cp -r "$sources/generated" "$both"
rm "$both"/magicmass/*.hpp
"$program" generate --out "$both" >/dev/null 2>&1 &
while kill -0 $! 2>/dev/null && no_part_files "$both"; do sleep 0.005; done
kill -KILL $! 2>/dev/null || true
wait $! 2>/dev/null || true
check "killed while generating: files are whole or missing" only_missing "$both"
# What it left is taken over by the next.
"$program" generate --out "$both" >"$scratch/first" 2>&1 &
first=$!
run "$program" generate --out "$both"
wait $first || status=1
check "two generate at once: both end well" test "$status" == 0
check "two generate at once: every file is right, and nothing else is left" diff -r "$sources/generated" "$both"

# Other places: no home, no variables at all, another clock, a decimal comma.
"$program" eval --alpha 0.1 --n 2 --format csv >"$scratch/expected"
"$program" simulate "$scene" >>"$scratch/expected"
"$program" ratios --count 3 --digits 30 >>"$scratch/expected"
all() { # prefix of the command line
  "$@" "$program" eval --alpha 0.1 --n 2 --format csv && "$@" "$program" simulate "$scene" &&
    "$@" "$program" ratios --count 3 --digits 30
}
same() { fine && cmp "$scratch/expected" "$scratch/output"; }
run all env -u HOME
check "no HOME" same
run all env -i ${LSAN_OPTIONS:+"LSAN_OPTIONS=$LSAN_OPTIONS"} # for a build that looks for leaks: which are not ours
check "no environment" same
run all env HOME=/nonexistent TMPDIR=/nonexistent
check "a HOME that is not there" same
for line in "figure terminal" "learn check collision_by_collision $(echo "$sources"/tutorials/*/exercises/collision_by_collision/solution/answer.cpp) --folder $scratch/mine"; do
  read -ra words <<<"$line"
  run env TMPDIR=/nonexistent "$program" "${words[@]}"
  check "a TMPDIR that is not there: ${words[0]}" refused
done
for zone in Pacific/Chatham Antarctica/Troll :nonsense; do
  run all env TZ=$zone
  check "time zone $zone" same
done
mkdir "$scratch/locales"
if localedef -i de_DE -f UTF-8 "$scratch/locales/de_DE.UTF-8" 2>/dev/null; then
  run all env LOCPATH="$scratch/locales" LC_ALL=de_DE.UTF-8
  check "decimal comma" same
else
  echo "skipped: decimal comma (Debian: locales)"
fi
run all env LC_ALL=no_SUCH.locale
check "a locale that is not installed" same

((failures == 0))
