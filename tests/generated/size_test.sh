#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# All that is generated is below 300 kB; more is refused, as a planted folder shows.
#   size_test.sh SOURCE
set -euo pipefail
most=300000

bytes_in() { find "$1" -type f -exec cat {} + | wc -c; }
is_small() { (($(bytes_in "$1") < most)); }

planted=$(mktemp -d)
trap 'rm -rf "$planted"' EXIT
mkdir "$planted/deep"
head -c 299999 /dev/zero >"$planted/deep/file"
is_small "$planted" || { echo "FAILED: 299999 bytes are refused"; exit 1; }
echo >"$planted/line"
if is_small "$planted"; then echo "FAILED: 300000 bytes pass"; exit 1; fi

is_small "$1/generated" || { echo "FAILED: generated/ has $(bytes_in "$1/generated") bytes, at most $most are allowed"; exit 1; }
echo "passed: generated/ has $(bytes_in "$1/generated") bytes"
