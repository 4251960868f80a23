#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Interrupted, killed, out of room, beside another: a file is as it was or whole, and what a killed program left beside
# it is used up by the next. What else goes wrong around a program is in faults_test.sh.
#   interrupted_test.sh PROGRAM SOURCES
set -euo pipefail
program=$1 sources=$2
scratch=$(mktemp -d)
trap 'chmod -R u+w "$scratch"; rm -rf "$scratch"' EXIT
# shellcheck source=tests/command/fault_checks.sh
source "$sources/tests/command/fault_checks.sh"
holds_only() { # folder, names
  [[ $(ls -A "$1") == "$(printf '%s\n' "${@:2}")" ]]
}
fresh() { rm -rf "$scratch/place" && mkdir "$scratch/place"; }
at_work() { # signal; sends it to a program that is writing $scratch/place/ratios
  "$program" ratios --count 100000000 --digits 30 -o "$scratch/place/ratios" 2>"$scratch/errors" &
  until [[ -s $scratch/place/ratios.part-1 ]] || ! kill -0 $! 2>/dev/null; do sleep 0.01; done
  kill -"$1" $!
  status=0
  wait $! 2>/dev/null || status=$?
}

fresh
check "a folder with nothing in it holds no file of that name" not holds_only "$scratch/place" ratios
"$program" ratios --count 40 -o "$scratch/whole"

# Interrupted: gone without a trace. Killed: what it left is taken over by the next.
for signal in INT TERM HUP; do
  fresh
  if [[ $signal == INT ]]; then set -m; fi # a background process ignores it otherwise
  at_work $signal
  set +m
  check "SIG$signal: it ends by the signal" test "$status" == $((128 + $(kill -l $signal)))
  check "SIG$signal: nothing is left" holds_only "$scratch/place"
done
fresh
echo precious >"$scratch/place/ratios"
at_work TERM
check "SIGTERM: the file that was there is as it was" test "$(<"$scratch/place/ratios")" == precious
fresh
at_work KILL
check "SIGKILL: beside the name, never at it" holds_only "$scratch/place" ratios.part-1
run "$program" ratios --count 40 -o "$scratch/place/ratios"
check "the next to write it is right" cmp "$scratch/whole" "$scratch/place/ratios"
check "and uses up what the killed one left" holds_only "$scratch/place" ratios

# A folder for temporary files, as soon as it is there and while a compiler's parts are putting files into it.
mkdir "$scratch/bin"
cat >"$scratch/bin/c++" <<'END'
#!/usr/bin/env bash
for ((i = 0; i < 100000; ++i)); do for name in 1 2 3 4; do : >"$TMPDIR/$name.part"; done; done 2>/dev/null &
echo $! >"${TMPDIR%/*}.compiles"
wait
END
chmod +x "$scratch/bin/c++"
compiles() { # a part of the compiler, one that has ended and that nobody asked for its status aside
  [[ -s $scratch/place.compiles ]] && grep -qs '^State:.[^Z]' "/proc/$(<"$scratch/place.compiles")/status"
}
answer=$(echo "$sources"/tutorials/*/exercises/collision_by_collision/solution/answer.cpp)
for moment in '' /4.part; do
  for signal in INT TERM HUP; do
    fresh
    rm -f "$scratch/place.compiles"
    if [[ $signal == INT ]]; then set -m; fi
    PATH=$scratch/bin:$PATH TMPDIR=$scratch/place "$program" learn check collision_by_collision "$answer" \
      --folder "$scratch/course" >/dev/null 2>"$scratch/errors" &
    set +m
    until seen=$(compgen -G "$scratch/place/magicmass-*$moment") || ! kill -0 $! 2>/dev/null; do sleep 0.01; done
    check "SIG$signal$moment: there is a folder for temporary files" test -n "$seen" # the first of several
    kill -$signal $!
    wait $! 2>/dev/null || true
    for _ in {1..100}; do
      holds_only "$scratch/place" && not compiles && break
      sleep 0.05
    done
    check "SIG$signal$moment: it is gone afterwards" holds_only "$scratch/place"
    check "SIG$signal$moment: and nobody goes on compiling" not compiles
  done
done

# A part file that somebody is writing is left alone.
if type -P flock >/dev/null; then
  fresh
  echo theirs >"$scratch/place/ratios.part-1"
  run flock "$scratch/place/ratios.part-1" "$program" ratios --count 40 -o "$scratch/place/ratios"
  check "two write one file: the other's part is left alone" test "$(<"$scratch/place/ratios.part-1")" == theirs
  check "two write one file: both end well" cmp "$scratch/whole" "$scratch/place/ratios"
fi
fresh
ln -s "$scratch/whole" "$scratch/place/ratios.part-1"
run "$program" ratios --count 3 -o "$scratch/place/ratios"
check "a link in the part file's place is not followed" refused
check "a link in the part file's place: what it points to is whole" test "$(wc -l <"$scratch/whole")" -gt 40
fresh
for _ in 1 2 3 4; do "$program" ratios --count 40 -o "$scratch/place/ratios" & done
status=0
for job in $(jobs -p); do wait "$job" || status=$?; done
check "four write one file: all end well" test "$status" == 0
check "four write one file: it is whole" cmp "$scratch/whole" "$scratch/place/ratios"
check "four write one file: nothing else is left" holds_only "$scratch/place" ratios

asked=$("$program" learn list --format csv --folder "$scratch/place/class" | awk -F, 'NR > 1 && $3 == "symbolic" { print $1 }' | head -n 8)
for id in $asked; do "$program" learn check "$id" 1/7 --folder "$scratch/place/class" >/dev/null & done
judged=0 # one that cannot be read is not
for job in $(jobs -p); do
  status=0
  wait "$job" || status=$?
  if [[ $status == 1 ]]; then judged=$((judged + 1)); fi
done
check "answers to exercises at once: there are some" test "$judged" -gt 4
check "answers to exercises at once: all are kept" \
  test "$(grep -cE '^[a-z_]+ [a-z]+ 1 0 0$' "$scratch/place/class/progress.txt")" == "$judged"

# No room.
fresh
run bash -c 'ulimit -f 4 && exec "$@"' - "$program" ratios --count 4000 -o "$scratch/place/ratios"
check "larger than files may be: refused" refused
check "larger than files may be: nothing is left" holds_only "$scratch/place"
mount_and() { # options of the mount, the program's arguments; $scratch/place is a tmpfs of that kind for them alone
  # shellcheck disable=SC2016
  run unshare -rm bash -c 'mount -t tmpfs -o "$1" none "$2" || exit 77
    "${@:3}"; code=$?
    [[ -z $(find "$2" -type f) ]] || echo "left: $(find "$2" -type f)" >&2
    exit $code' - "$1" "$scratch/place" "$program" "${@:2}"
}
if unshare -rm true 2>/dev/null; then
  fresh
  for line in "generate --out $scratch/place/generated" "animate $scene -o $scratch/place/a.html" \
    "learn new mine --kind symbolic --chapter 04_sequences --content $scratch/place/content"; do
    read -ra words <<<"$line"
    mount_and size=4k "${words[@]}"
    [[ $status == 77 ]] || check "no room: ${words[0]}" refused
  done
  for line in "manual --man $scratch/place/man" "learn show --folder $scratch/place/mine" \
    "animate $scene -o $scratch/place/a.html" "figure terminal -o $scratch/place/t.svg" "demo --out $scratch/place/demo" \
    "learn new mine --kind symbolic --chapter 04_sequences --content $scratch/place/content"; do
    read -ra words <<<"$line"
    mount_and ro "${words[@]}"
    [[ $status == 77 ]] || check "read-only: ${words[0]} ${words[1]}" refused
  done
else
  echo "skipped: a small and a read-only file system (no mount of our own)"
fi

# Standard streams that are closed: no file gets their numbers.
for closed in '<&-' '>&-' '2>&-' '<&- >&- 2>&-'; do
  fresh
  status=0
  eval "\"\$program\" ratios --count 40 -o \"\$scratch/place/ratios\" $closed" || status=$?
  check "closed $closed: the file is right" cmp "$scratch/whole" "$scratch/place/ratios"
  eval "\"\$program\" count --alpha none -o \"\$scratch/place/ratios\" $closed" 2>/dev/null || true
  check "closed $closed: a refusal does not get into it" cmp "$scratch/whole" "$scratch/place/ratios"
done

# Decimal commas and clocks, wherever numbers are read or printed.
all() { # prefix of the command line
  "$@" "$program" count --alpha 0.12 && "$@" "$program" terminal --alpha 0.12 --restitution 0.9 --format json &&
    "$@" "$program" figure terminal --format csv && "$@" "$program" plan "$scene" &&
    "$@" "$program" equal 0.5 1/2 && "$@" "$program" eval --alpha 0x1.8p-3 --n 1 --digits 20
}
all env >"$scratch/expected"
mkdir "$scratch/locales"
if localedef -i de_DE -f UTF-8 "$scratch/locales/de_DE.UTF-8" 2>/dev/null; then
  run all env LOCPATH="$scratch/locales" LC_ALL=de_DE.UTF-8 LANGUAGE=de
  check "decimal comma" cmp "$scratch/expected" "$scratch/output"
else
  echo "skipped: decimal comma (Debian: locales)"
fi
for zone in Pacific/Kiritimati America/St_Johns; do
  run all env TZ=$zone
  check "time zone $zone" cmp "$scratch/expected" "$scratch/output"
done

((failures == 0))
