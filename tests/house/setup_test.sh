#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Shows what `setup` does on machines of every kind, without installing anything: its PATH holds
# made-up dpkg-query, apt-get, id and sudo that read the machine from $machine and record calls there.
set -euo pipefail

setup=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/setup
bash=$(type -P bash)
machine=$(mktemp -d)
trap 'rm -rf "$machine"' EXIT
export machine
failures=0

program() { # name; the body, from standard input: one of the machine's programs
  { echo "#!$bash" && cat; } >"$machine/bin/$1"
  chmod +x "$machine/bin/$1"
}

new_machine() { # user id, packages installed
  rm -rf "${machine:?}"/*
  mkdir "$machine/bin"
  ln -s "$(type -P env)" "$(type -P mktemp)" "$(type -P rm)" "$(type -P tail)" "$machine/bin"
  echo "$1" >"$machine/user"
  echo " ${*:2} " >"$machine/installed"
  : >"$machine/calls"
  program id <<'END'
echo "$(<"$machine/user")"
END
  program dpkg-query <<'END'
status=0
for name in "$@"; do
  case $name in -*) continue ;; esac
  if [[ $(<"$machine/installed") == *" $name "* ]]; then
    echo "$name installed"
  elif [[ $name == cmake ]]; then
    echo "$name config-files" # removed, not purged
  else
    echo "dpkg-query: no packages found matching $name" >&2 && status=1
  fi
done
exit $status
END
  program apt-get <<'END'
echo "apt-get as $(<"$machine/user"), ${DEBIAN_FRONTEND-interactive}: $*" >>"$machine/calls"
for line in {1..300}; do echo "Selecting previously unselected package number $line"; done
for word in "$@"; do
  if [[ -e $machine/no-$word ]]; then echo "E: no $word today" >&2 && exit 100; fi
done
END
}

with_sudo() {
  program sudo <<'END'
echo sudo >>"$machine/calls"
echo 0 >"$machine/user"
exec "$@"
END
}

run() { # options of setup; leaves status, output, calls
  status=0
  output=$(PATH=$machine/bin "$bash" "$setup" "$@" 2>&1 </dev/null) || status=$?
  calls=$(<"$machine/calls")
  installs=$(sed -n 's/^apt-get as .*--no-install-recommends //p' <<<"$calls")
}

expect() { # what this shows, then a test command
  if "${@:2}"; then
    echo "passed: $1"
  else
    failures=$((failures + 1))
    printf 'FAILED: %s\n  status: %s\n  output: %s\n  calls: %s\n' "$1" "$status" "$output" "$calls"
  fi
}
equal() { [[ $1 == "$2" ]]; }
contains() { [[ $1 == *"$2"* ]]; }
lines_at_most() { (($(wc -l <<<"$2") <= $1)); }

# Written out a second time on purpose: adding a package to `setup` is a decision.
needed=(g++ make cmake pkg-config libginac-dev libcln-dev libeigen3-dev libfmt-dev catch2
  libcli11-dev libtomlplusplus-dev nlohmann-json3-dev gnuplot-nox)

new_machine 0 "${needed[@]}"
run
expect "nothing missing: success" equal "$status" 0
expect "nothing missing: says so in one line" lines_at_most 1 "$output"
expect "nothing missing: apt is not touched" equal "$calls" ""

new_machine 0
run
expect "bare machine: success" equal "$status" 0
expect "bare machine: exactly the packages needed" equal "$installs" "${needed[*]}"
expect "bare machine: lists refreshed, then one install" equal "$(wc -l <<<"$calls") ${calls%% update*}" \
  "2 apt-get as 0, noninteractive: -qq -o DPkg::Lock::Timeout=300"
expect "bare machine: apt's chatter stays off the terminal" lines_at_most 2 "$output"

new_machine 0 g++ make pkg-config libginac-dev libcln-dev libeigen3-dev libfmt-dev catch2 \
  libcli11-dev libtomlplusplus-dev gnuplot-nox
run
expect "two missing: exactly these two, a removed one counting as missing" \
  equal "$installs" "cmake nlohmann-json3-dev"

new_machine 0 "${needed[@]}"
run --all
expect "--all: the optional tools too" contains " $installs " " pandoc "
expect "--all: nothing that is there already" equal "${installs/g++/}" "$installs"
new_machine 0 "${needed[*]} $installs"
run --all
expect "--all a second time: apt is not touched" equal "$status $calls" "0 "

new_machine 1000 g++
with_sudo
run
expect "user with sudo: installs through sudo" equal "$status ${calls%%$'\n'*}" "0 sudo"
expect "user with sudo: apt asks no questions there either" contains "$calls" "as 0, noninteractive:"

new_machine 1000 "${needed[@]:1}"
run
expect "user without sudo: status 1" equal "$status" 1
expect "user without sudo: told the command to run" contains "$output" \
  "apt-get update && apt-get install -y --no-install-recommends g++"
expect "user without sudo: apt is not touched" equal "$calls" ""

new_machine 0 "${needed[@]:1}"
touch "$machine/no-update"
run
expect "no network, package in apt's cache: installed all the same" equal "$status $installs" "0 g++"
touch "$machine/no-install"
run
expect "no network: status 1" equal "$status" 1
expect "no network: apt's own error is shown" contains "$output" "E: no install today"
expect "no network: the last line says what to run" contains "${output##*$'\n'}" "apt-get install -y"

new_machine 0
rm "$machine/bin/apt-get"
run
expect "not Debian: status 1" equal "$status" 1
expect "not Debian: one line that names the packages" equal "$(wc -l <<<"$output") ${output##*: }" \
  "1 ${needed[*]}"

new_machine 0
run --everything
expect "unknown option: status 2" equal "$status" 2
expect "unknown option: one line that names it" equal "$(wc -l <<<"$output") ${output%%;*}" \
  "1 setup: unknown option '--everything'"
expect "unknown option: apt is not touched" equal "$calls" ""

run --help
expect "--help: success, an example first" equal "$status ${output%%:*}" "0 Example"

((failures == 0))
