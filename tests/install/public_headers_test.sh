#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# What an installed header includes of ours is installed, too; and this would see it if one were missing.
#   public_headers_test.sh INCLUDE
set -euo pipefail

missing_below() { # include folder
  local header path
  while read -r header; do
    sed -nE 's/^#include "([^"]+)".*/\1/p' "$header" | while read -r path; do
      [[ -f $1/$path || -f $1/magicmass-symbolic/$path ]] || echo "$header includes $path"
    done
  done < <(find "$1" -name '*.hpp')
}

missing=$(missing_below "$1")
if [[ -n $missing ]]; then
  echo "not installed: $missing" >&2
  exit 1
fi
spoiled=$(mktemp -d)
trap 'rm -rf "$spoiled"' EXIT
cp -r "$1/." "$spoiled"
rm "$spoiled/magicmass/counts.hpp"
[[ $(missing_below "$spoiled") == *"includes magicmass/counts.hpp"* ]] || {
  echo "a missing header was not noticed" >&2
  exit 1
}
