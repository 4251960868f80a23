#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# A program prints what a file says; and this test would see it if one character differed.
#   output_test.sh PROGRAM EXPECTED
set -euo pipefail

same() { diff <("$1") "$2"; }

same "$1" "$2"
if same "$1" <(sed '1s/./X/' "$2") >/dev/null; then
  echo "a spoiled $2 was not noticed"
  exit 1
fi
