#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# For tests of what goes wrong around a program, which source this and have set $sources and $scratch.
failures=0
scene=$sources/tutorials/scenes/trajectory_a.toml

check() { # what this shows; a condition
  if "${@:2}"; then
    echo "passed: $1"
  else
    failures=$((failures + 1))
    printf 'FAILED: %s\n  status %s, stderr: %s\n' "$1" "${status-}" "$(head -c 400 "$scratch/errors")"
  fi
}
run() { # a command line; leaves status, $scratch/output and $scratch/errors
  status=0
  "$@" >"$scratch/output" 2>"$scratch/errors" || status=$?
}
refused() { [[ $status == 2 && $(wc -l <"$scratch/errors") == 1 && $(<"$scratch/errors") == magicmass:* ]]; }
not() { ! "$@"; }
