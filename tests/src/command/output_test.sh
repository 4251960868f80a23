#!/usr/bin/env bash
# Where an answer goes: whole or not at all, beside what others have there. output_test.sh PROGRAM
set -euo pipefail
export LC_ALL=C
program=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
failed=0
check() { # what it shows, command
  if "${@:2}"; then echo "passed: $1"; else
    echo "FAILED: $1"
    failed=1
  fi
}
run() { # command, whose exit code is then in status
  status=0
  "$@" || status=$?
}
holds() { [[ $(cat "$1") == "$2" ]]; }                      # file, text
only() { [[ $(ls -A) == "$(printf '%s\n' "$@" | sort)" ]]; } # names
fresh() { rm -rf "$scratch/place" && mkdir "$scratch/place" && cd "$scratch/place"; }
three=$'1\n2\n3'

fresh
"$program" many --lines 3 -o new
check "a new file, with the mode of the umask" \
  test "$(stat -c %a new)" = "$(printf %o $((0666 & ~$(umask))))"
check "it is whole" holds new "$three"
echo old >kept && chmod 640 kept
"$program" many --lines 3 -o kept
check "a file that is replaced keeps its mode" test "$(stat -c %a kept)" = 640
check "and has the new text" holds kept "$three"
ln -s kept link && ln -s later dangling
"$program" many --lines 1 -o link
"$program" many --lines 2 -o dangling
check "a link stays a link" test -L link -a -L dangling
check "what it points to is written" holds kept 1
check "what a dangling link points to is made" holds later $'1\n2'
check "nothing else is left" only dangling kept later link new

fresh
echo mine >".magicmass-1-0" && echo old >file
"$program" check -o file || true
check "a failed check is written" holds file "not proved"
check "somebody's file is not consumed" holds .magicmass-1-0 mine
run "$program" crash -o file 2>errors
check "after a crash the file is as it was" holds file "not proved"
check "and the exit code is 3" test $status = 3
run "$program" many --lines 100000 -o file 2>errors --time-limit 1
check "enough time: done" test $status = 0
(ulimit -f 8 && "$program" many --lines 100000 -o file 2>errors) || true
check "a file too large for its limit: refused" grep -q 'cannot write file: File too large' errors
check "and the old one is there, whole" test "$(tail -n 1 file)" = 100000

fresh
{ echo before && "$program" many --lines 1 -o /dev/stdout && echo after; } >group
check "-o /dev/stdout writes between the other lines" holds group $'before\n1\nafter'
{ echo before && "$program" many --lines 1 -o /dev/fd/3 && echo after; } 3>three >group
check "-o /dev/fd/3" holds three 1
"$program" many --lines 3 -o /dev/null
check "a device is written, not replaced" test -c /dev/null
mkfifo pipe && cat pipe >from_pipe &
until [[ -p pipe ]]; do sleep 0.01; done
"$program" many --lines 3 -o pipe
wait
check "a pipe is written, not replaced" test -p pipe
check "and all of it arrives" holds from_pipe "$three"
"$program" many --lines 1000000 | head -n 1 >first
check "a reader that goes away is not an error" test "${PIPESTATUS[0]}" = 0
if command -v perl >/dev/null; then
  unblocked='use Fcntl; fcntl(STDOUT, F_SETFL, O_NONBLOCK); exec @ARGV'
  perl -e "$unblocked" "$program" many --lines 100000 | (sleep 0.2 && tail -n 1) >last
  check "a pipe that does not block: all of it arrives" holds last 100000
  (echo text; sleep 0.3; echo first) |
    perl -e "${unblocked//STDOUT/STDIN}" "$program" echo --input - --format csv >rows || true
  check "and so it does from one" holds rows $'text,times\nfirst,'
fi
coproc "$program" echo --input - --format csv
echoing=$COPROC_PID  # the shell forgets it as soon as that ends
printf 'text\nfirst\n' >&"${COPROC[1]}"
read -r -t 20 line <&"${COPROC[0]}" && read -r -t 20 line <&"${COPROC[0]}" || true
check "a row from a pipe is answered before the next one comes" test "${line-}" = first,
eval "exec ${COPROC[1]}>&-"
wait "$echoing" || true
ln -s round about && ln -s about round
"$program" many --lines 3 -o round 2>errors || true
check "links in a circle stay" test -L round -a -L about
check "and are refused" grep -q 'cannot write round: Too many levels' errors
"$program" many --lines 3 -o whole <&- >&- 2>&-
check "with all streams closed the file is whole" holds whole "$three"
run "$program" many --lines 3 >&- 2>errors
check "closed stdout: said in one line" test $status = 2 -a "$(wc -l <errors)" = 1
run "$program" many --lines 3 <&- >&- 2>errors
check "closed stdin and stdout: said in one line" test $status = 2 -a "$(wc -l <errors)" = 1
run "$program" bug 2>/dev/full
check "a full stderr does not change the exit code" test $status = 3

fresh
for signal in INT TERM HUP KILL; do
  if [[ $signal == INT ]]; then set -m; fi # a background process ignores it otherwise
  "$program" wait -o file 2>errors &
  set +m
  until pgrep -P $! >/dev/null; do sleep 0.01; done
  child=$(pgrep -P $!)
  kill -$signal $!
  run wait $! 2>/dev/null
  check "SIG$signal: it ends by the signal" test $status = $((128 + $(kill -l $signal)))
  for _ in {1..200}; do [[ -e /proc/$child/exe ]] || break; sleep 0.01; done
  check "SIG$signal: its child is gone" test ! -e "/proc/$child/exe"
  check "SIG$signal: no file" only errors
done

fresh
"$program" wait 2>errors &
until pgrep -P $! >/dev/null; do sleep 0.01; done
kill -TERM "$(pgrep -P $!)"
run wait $! 2>/dev/null
check "the child alone ended by SIGTERM: so does the program" test $status = 143

fresh
gone() { # what, process: it and its folder are, soon
  for _ in {1..300}; do [[ -e /proc/$2/exe || $(ls -A "$TMPDIR") ]] || break; sleep 0.01; done
  check "$1: another program is gone" test ! -e "/proc/$2/exe"
  check "$1: and its folder" test -z "$(ls -A "$TMPDIR")"
}
export TMPDIR=$scratch/place
for signal in INT KILL none; do
  set -m
  "$program" other --time-limit $([[ $signal == none ]] && echo 1 || echo 60) 2>../errors &
  set +m
  until [[ -e $(echo magicmass-*/file) ]]; do sleep 0.01; done
  sleeper=$(pgrep -f 'sleep 60' -P "$(pgrep -d, -P "$(pgrep -P $!)")") # its watcher's child
  if [[ $signal == none ]]; then
    run wait $!
    check "late: exit code 3" test $status = 3
    check "late: no folder is left when it says so" test -z "$(ls -A)"
  else
    kill -$signal $!
    wait $! 2>/dev/null || true
  fi
  gone "SIG$signal" "$sleeper"
done
unset TMPDIR
(trap '' INT && exec "$program" wait --time-limit 2 2>errors) &
until pgrep -P $! >/dev/null; do sleep 0.01; done
kill -INT $! "$(pgrep -P $!)"
run wait $!
check "SIGINT that is ignored on entry stays ignored" test $status = 3

fresh
(for _ in {1..8}; do "$program" many --lines 20000 -o both & done; wait)
check "writers at once: the file is whole" test "$(wc -l <both)" = 20000
check "writers at once: nothing is left" only both
env -i ${LSAN_OPTIONS:+"LSAN_OPTIONS=$LSAN_OPTIONS"} "$program" echo --text 0.5 --format json >bare
LC_ALL=de_DE.UTF-8 TZ=Mars TMPDIR=/nowhere "$program" echo --text 0.5 --format json >odd
check "no environment, an odd one: the same bytes" cmp bare odd
printf 'text,times\n"0,5",3\n' >decimal.csv
for locale in C C.UTF-8 de_DE.UTF-8 tr_TR.ISO-8859-9; do
  HOME=/nowhere LC_ALL=$locale LANG=$locale LC_CTYPE=$locale TERM=dumb NO_COLOR=1 \
    "$program" echo --input decimal.csv
done >each
check "locales, installed or not: the same bytes" test "$(sort -u each | wc -l)" = 2
if command -v script >/dev/null; then
  for terminal in xterm dumb; do
    TERM=$terminal script -qec "$program wait --time-limit 3" $terminal.log \
      >/dev/null </dev/null || true
  done
  check "a terminal sees how long it has been" grep -q 'wait: 1 s of at most 3 s' xterm.log
  check "a dumb one does not" test "$(grep -c 'of at most' dumb.log)" = 0
fi
exit $failed
