#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Debian packages from the build: unpacked into a folder, the program runs there on its own files.
#   packages_test.sh BUILD VERSION
set -euo pipefail
build=$1 version=$2
if ! type -P dpkg-deb dpkg-shlibdeps >/dev/null; then
  echo "skipped: no dpkg-dev"
  exit 77
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() {
  echo "FAILED: $*" >&2
  exit 1
}

(cd "$build" && cpack -B "$scratch" >"$scratch/log" 2>&1) || fail "$(tail -5 "$scratch/log")"
for name in magicmass libmagicmass-dev; do
  package=$(find "$scratch" -maxdepth 1 -name "${name}_*.deb")
  [[ $(dpkg-deb -f "$package" Package Version) == "Package: $name"$'\n'"Version: $version" ]] ||
    fail "$package: $(dpkg-deb -f "$package")"
  [[ -n $(dpkg-deb -f "$package" Depends) ]] || fail "$name depends on nothing"
  dpkg-deb -x "$package" "$scratch/root-$name"
done
[[ $(dpkg-deb -f "$scratch"/magicmass_*.deb Depends) == *libginac* ]] || fail "magicmass does not ask for GiNaC"
[[ ! -e $scratch/root-magicmass/usr/include ]] || fail "headers are in the program's package"
[[ ! -e $scratch/root-libmagicmass-dev/usr/bin ]] || fail "the program is in the library's package"

files() { (cd "$scratch/root-$1" && find . -type f | sort); }
both=$(comm -12 <(files magicmass) <(files libmagicmass-dev))
[[ -z $both ]] || fail "dpkg would not install the two together, for both have $both"

program=$scratch/root-magicmass/usr/bin/magicmass
run() { (cd / && env -i PATH=/usr/bin:/bin "$program" "$@"); }
[[ $(run --version) == "magicmass $version" ]] || fail "the packaged program's version"
[[ $(run doctor) == *"$scratch/root-magicmass/usr/share/magicmass/generated"* ]] || fail "doctor: $(run doctor)"
if type -P pandoc >/dev/null; then
  [[ -s $scratch/root-magicmass/usr/share/doc/magicmass/course/index.html ]] || fail "the course is not in the package"
fi
run plan "$scratch/root-magicmass/usr/share/magicmass/scenes/wall.toml" >/dev/null
run demo --out "$scratch/demo" >"$scratch/demo.txt" || fail "demo: $(tail -3 "$scratch/demo.txt")"
# A contest compiles the generated headers, which are the package's own.
contest() {
  run learn check beat_us "$scratch/root-magicmass/usr/share/magicmass/tutorials/13_speed_and_error/exercises/beat_us/solution/answer.cpp" \
    --folder "$scratch/answers"
}
[[ $(contest) == *"yours: worst error"* ]] || fail "beat_us: $(contest)"
mv "$scratch/root-magicmass/usr/share/magicmass/generated/magicmass/quantities.hpp" "$scratch"
if [[ $(contest) == *"yours: worst error"* ]]; then
  fail "without its headers a contest is held all the same: this test shows nothing"
fi
find "$scratch/root-magicmass" -name '*.toml' -delete
if run demo --out "$scratch/demo" >/dev/null 2>&1; then
  fail "without its scenes the demo runs all the same: this test shows nothing"
fi
echo "passed: $(find "$scratch" -maxdepth 1 -name '*.deb' -printf '%f ')"
