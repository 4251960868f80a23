#!/usr/bin/env bash
# The README's commands on a machine that has a release and git and nothing else: HEAD cloned into a
# bare root that debootstrap makes. Both must pass without a warning, and generate the same bytes.
# Needs root, debootstrap (Debian: debootstrap) and a network.
#   bare_machine.sh RELEASE          bookworm (Debian 12) or trixie (13)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
release=${1:?give a release of Debian: bookworm or trixie}
fail() {
  printf 'bare_machine.sh: %s\n' "$*" >&2
  exit 1
}
[[ $(id -u) == 0 ]] || fail "needs root"
type -P debootstrap >/dev/null || fail "needs debootstrap (Debian: debootstrap)"

root=$(mktemp -d --tmpdir "magicmass-$release.XXXXXX")
trap 'rm -rf --one-file-system "$root"' EXIT
mirror=$(sed -n 's/^URIs: *//p' /etc/apt/sources.list.d/debian.sources 2>/dev/null | head -n 1)
debootstrap --variant=minbase --include=ca-certificates,git "$release" "$root" \
  "${mirror:-http://deb.debian.org/debian}" >"$root.log" 2>&1 ||
  fail "debootstrap: $(tail -n 5 "$root.log")"
rm "$root.log"
git clone --quiet . "$root/root/magicmass"
cp /etc/resolv.conf "$root/etc/resolv.conf"

cat >"$root/root/commands.sh" <<'COMMANDS'
set -euo pipefail
cd /root/magicmass
printf '%s, %s\n' "$(. /etc/os-release && echo "$PRETTY_NAME")" "$(nproc) processors"
export TIMEFORMAT='%0R s, %0U s of processor time'
./setup
time ./setup && time cmake --workflow --preset demo
./setup && time cmake --workflow --preset test
build/default/bin/magicmass generate --check --out generated
[[ -z $(git status --porcelain) ]]
COMMANDS

# Its own processes, mounts and terminals, all gone with it.
# shellcheck disable=SC2016
unshare --mount --pid --fork --kill-child bash -euc '
  mount -t proc proc "$1/proc"
  mount --rbind /dev "$1/dev"
  mount -t devpts -o newinstance,ptmxmode=0666 devpts "$1/dev/pts"
  mount --bind "$1/dev/pts/ptmx" "$1/dev/ptmx"
  exec chroot "$1" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb \
    LANG=C.UTF-8 bash /root/commands.sh' - "$root" </dev/null 2>&1 | tee "$root/said" ||
  fail "$release: the commands failed"
if grep -n 'warning:' "$root/said"; then fail "$release: there are warnings"; fi
