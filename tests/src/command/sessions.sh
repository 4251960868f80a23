#!/usr/bin/env bash
# Replays sessions: sessions.sh [--update | --refusals] FOLDER NAME=PROGRAM... A session is
# FOLDER/sessions/*.txt, or session.txt of a chapter of tutorials/, which is at hand: after each
# line "$ COMMAND" what it prints, stderr too, and "[exit N]" where N is not 0. --update writes what
# is printed now. --refusals, instead: src/command/BOUNDS.md, what each step beyond says;
# FOLDER/refusals.tsv, a command, a tab, a part of its message: one line on stderr, exit code 2,
# nothing on stdout, no file.
set -euo pipefail
export LC_ALL=C
only=
if [[ ${1-} == --* ]]; then
  only=$1
  shift
fi
folder=$(cd "$1" && pwd)
tutorials=$(cd "$folder/../../../tutorials" && pwd)
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/bin" "$scratch/place" "$scratch/home"
export HOME=$scratch/home
unset XDG_STATE_HOME
for program in "$@"; do ln -s "$(realpath "${program#*=}")" "$scratch/bin/${program%%=*}"; done
PATH=$scratch/bin:$PATH
cd "$scratch/place"
ln -s "$tutorials"
failed=0

replay() { # session
  local line status
  while IFS= read -r line; do
    case $line in
      '$ '*)
        printf '%s\n' "$line"
        status=0
        bash -c "${line#??}" </dev/null 2>&1 || status=$?
        ((status == 0)) || echo "[exit $status]"
        ;;
      '# '*) printf '%s\n' "$line" ;;
    esac
  done <"$1"
}
for session in "$folder"/sessions/*.txt "$tutorials"/*/session.txt; do
  [[ $only != --refusals ]] || break
  # AddressSanitizer takes terabytes of addresses and has words of its own for a crash.
  [[ -z ${ASAN_OPTIONS-} || $session != */bounds.txt ]] || continue
  replay "$session" >"$scratch/seen"
  if [[ $only == --update ]]; then
    cp "$scratch/seen" "$session"
  elif ! diff -u "$session" "$scratch/seen"; then
    failed=1
  fi
done
[[ $only == --refusals ]] || exit $failed

rm -rf "$scratch/place" && mkdir "$scratch/place" && cd "$scratch/place"
while IFS=$'\t' read -r command part; do
  [[ $command && $command != '#'* ]] || continue
  status=0
  bash -c "$command" </dev/null >"$scratch/output" 2>"$scratch/errors" || status=$?
  if ((status != 2)) || [[ -s $scratch/output || -n $(ls -A) ]] ||
    [[ $(wc -l <"$scratch/errors") != 1 ]] ||
    ! grep -qF -- "$part" "$scratch/errors"; then
    printf 'refusals.tsv: %s: exit %s, %s\n' "$command" "$status" \
      "$(cat "$scratch/output" "$scratch/errors")"
    failed=1
  fi
done <"$folder/refusals.tsv"

# Rows of BOUNDS.md: the largest that is answered, seconds, MiB, a step beyond it, exit code, what
# it says. What takes longer is for the long preset.
expect() { # command, exit code, what it says
  local said status=0
  rm -rf "$scratch/place" && mkdir "$scratch/place" && cd "$scratch/place"
  said=$(bash -c "${1:1:-1}" </dev/null 2>&1) || status=$?
  [[ $status == "$2" && $said == *"$3"* ]] && return
  printf 'BOUNDS.md: %s: exit %s, %s\n' "$1" "$status" "${said:0:400}"
  failed=1
}
rows=0
while IFS='|' read -r _ largest seconds _ beyond status says _; do
  [[ -z ${ASAN_OPTIONS-} && $largest == *magicmass* && $beyond == *magicmass* ]] || continue
  read -r largest <<<"$largest" && read -r beyond <<<"$beyond" && read -r says <<<"$says"
  is_quick=0
  [[ ${seconds%.*} -ge 2 && -z ${MAGICMASS_LONG-} ]] || is_quick=1
  ((status == 3 && !is_quick)) || expect "$beyond" $status "$says"
  ((!is_quick || ${seconds%.*} >= 20)) || expect "$largest" 0 "" # machines differ by a third
  ((rows += 1))
done <"$folder/../../../src/command/BOUNDS.md"
((rows > 20)) || [[ ${ASAN_OPTIONS-} ]] || failed=1
exit $failed
