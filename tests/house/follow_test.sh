#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The page "Follow a_n" in CONTRIBUTING.md: at most 18 files, which are there, and each is named by the build or included.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mapfile -t files < <(sed -n '/^## Follow a_n/,$s/^| `\([^`]*\)`.*/\1/p' CONTRIBUTING.md)
((${#files[@]} >= 10 && ${#files[@]} <= 18)) || { echo "${#files[@]} files, 10 to 18 are allowed"; exit 1; }
for file in "${files[@]}"; do
  [[ -f $file ]] || { echo "CONTRIBUTING.md: no file $file"; exit 1; }
  name=$(basename "$file")
  grep -rqF --include=CMakeLists.txt --include='*.cpp' --include='*.hpp' "$name" . ||
    { echo "CONTRIBUTING.md: nothing builds or includes $file"; exit 1; }
done
