#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Halves entries of the table of operations and drops terms of the rules, one at a time: the tests must turn red.
# usage: spoiled.sh COMPILER SOURCE_DIR CODEGEN_LIBRARY KERNEL_LIBRARY TEST_OBJECT_OR_LIBRARY...
set -euo pipefail
export compiler=$1 source=$2 libraries="$3 $4"
shift 4
export objects="$*"
work=$(mktemp -d)
export work
trap 'rm -rf "$work"' EXIT

# FILE and a sed command. Halves of these entries are not seen and not listed: what a sum that cancels
# loses of its result (the table allows twice what can happen), and what a turned angle loses of itself
# and near a quarter turn (there the sine's entry allows for more than both).
spoiled() {
  cat <<'LIST'
operations.cpp|s/Loss{0, u} : Loss{u, 0}/Loss{0, u} : Loss{u \/ 2, 0}/
operations.cpp|s/Loss{lost, u} : Loss{u, 0}/Loss{lost, u} : Loss{u \/ 2, 0}/
operations.cpp|s/Loss{u \* (2 \* l + u) \* and_more/Loss{0.5 * u * (2 * l + u) * and_more/
operations.cpp|s/(u + l) \* and_more}/0.5 * (u + l) * and_more}/
operations.cpp|s/return {3 \* u \* x/return {1.5 * u * x/
operations.cpp|s/3 \* u \* y \* and_more/1.5 * u * y * and_more/
operations.cpp|s/u \* u \* and_more, 3 \* u/u * u * and_more, 0.9 * u/
operations.cpp|s/return {(x \* y + u/return {0.5 * (x * y + u/
operations.cpp|s/(x + y + u) \* and_more}/0.5 * (x + y + u) * and_more}/
operations.cpp|s/Loss{u \* (x + u) \* and_more/Loss{0.5 * u * (x + u) * and_more/
operations.cpp|s/and_more, (x + u) \* and_more/and_more, 0.5 * (x + u) * and_more/
operations.cpp|s/return {(u \* (10 \* u/return {0.5 * (u * (10 * u/
operations.cpp|s/, d \* and_more};/, 0.5 * d * and_more};/
operations.cpp|s/return {(0.375 \* e/return {0.5 * (0.375 * e/
operations.cpp|s/and_more, e \/ 2 \* and_more/and_more, e \/ 4 * and_more/
operations.cpp|s/return {E \* and_more/return {0.5 * E * and_more/
operations.cpp|s/p.error, L \* and_more/p.error, 0.5 * L * and_more/
operations.cpp|s/+ p.error, /+ 0.5 * p.error, /
operations.cpp|s/return {(q.loss + q.slope/return {0.45 * (q.loss + q.slope/
operations.cpp|s/return {{(of_s.loss/return {{0.5 * (of_s.loss/
operations.cpp|s/{(of_c.loss + of_c.slope \* square/{0.5 * (of_c.loss + of_c.slope * square/
operations.cpp|s/const Loss either{/const Loss either{0.5 * /
operations.cpp|s/, std::max(sine.loose, cosine.loose)}/, 0.5 * std::max(sine.loose, cosine.loose)}/
operations.cpp|s/and_more, spill};/and_more, 0.5 * spill};/
operations.cpp|s/return (is_pair() ? u \* x : u)/return 0.5 * (is_pair() ? u * x : u)/
operations.cpp|s/const double off = most \*/const double off = 0.5 * most */
errors.cpp|s/needed(x), p\[y\].range.high));/needed(x), 0.4 * p[y].range.high));/
errors.cpp|s/add(f, {{{}, least_power \* 2}});/;/
errors.cpp|s/^ *add(f, error(o));/;/
errors.cpp|s/add_loss(f, \*of_x + \*of_y + \*of_x \* \*of_y, k);/add_loss(f, *of_x, k);/
errors.cpp|s/add_loss(f, (\*r + of_y) \* and_more, k);/add_loss(f, *r, k);/
errors.cpp|s/add_loss(f, needed(x) \* 0.5 \* and_more, k);/;/
errors.cpp|s/add_loss(f, needed(x) \* and_more, k);/;/
errors.cpp|s/add(f, error(x), std::fabs(n.factor));/;/
errors.cpp|s/add_loss(f, std::max(\*of_x, \*of_y), k);/;/
errors.cpp|s/(\*r + of_turn) \* std::max/0.5 * (*r + of_turn) * std::max/
errors.cpp|s/add(f, plain, std::sin(top)/add(f, plain, 0.4 * std::sin(top)/
errors.cpp|s/add(f, plain, and_more);/;/
errors.cpp|s/add_sized(f, error(x), y);$/;/
errors.cpp|s/add_sized(f, error(y), x);/;/
errors.cpp|s/take(n.op == Op::sine ? of.sine : of.cosine);/here.loose = 0x1p-50;/
errors.cpp|s/add(f, error(y), and_more \/ p/add(f, error(y), 0.5 * and_more \/ p/
errors.cpp|s/add(f, error(y), and_more \/ p.*$/;/
errors.cpp|s/{k, k});$/{k});/
errors.cpp|s/clear = 2 \/ close/clear = 1 \/ close/
errors.cpp|s/least->second < p\[k\].range.low/least->second < 0/
errors.cpp|s/if (is_divisor(y)) {/if (p[x].op == Op::constant) {/
errors.cpp|s/add_loss(f, t.is_pair() ? low(k) : t.u, k);/;/
errors.cpp|s/^    check_close(k);/;/
errors.cpp|s/if ((\*this)\[k\].spill > 0) throw/if (false) throw/
errors.cpp|s/if (!(here.loose >= 0 && here.loose <= loosest))/if (false)/
errors.cpp|s/ + 3 \* t.u \* (\*this)\[o\].spill//
errors.cpp|s/take(t.constant(lost(n)));/take(t.constant(0));/
errors.cpp|s/^      add_loss(f, of_y, k);/;/
errors.cpp|s/add_loss(angle, of.angle, x);/;/
errors.cpp|s/(\*r + of_turn) \*/*r */
errors.cpp|s/: 1) \* and_more;/: 1);/
emit_case.cpp|s/} else if (r.kind != Result::guard) {/} else if (r.kind == Result::sign) {/
form.cpp|s/f\[into\] += \*of_part/f[into] += 0.01 * *of_part/
form.cpp|s/by \*= most(v);$/by *= 0.25 * most(v);/
LIST
}
# Says what did not turn red.
try() {
  local file=${1%%|*} command=${1#*|} folder
  folder=$(mktemp -d "$work/XXXXXX")
  sed -e "$command" "$source/symbolic/codegen/$file" >"$folder/$file"
  if cmp -s "$source/symbolic/codegen/$file" "$folder/$file"; then
    echo "CHANGES NOTHING  $1"
  # shellcheck disable=SC2086
  elif ! "$compiler" -std=c++20 -O1 -w -ffp-contract=off -I"$source/symbolic" -c "$folder/$file" -o "$folder/spoiled.o" ||
    ! "$compiler" "$folder/spoiled.o" $objects $libraries -lginac -lcln -o "$folder/tests"; then
    echo "DOES NOT COMPILE OR LINK  $1"
  elif timeout 100 "$folder/tests" >/dev/null 2>&1; then
    echo "SURVIVED  $1"
  fi
  rm -rf "$folder"
}
export -f try
spoiled | tr '\n' '\0' | xargs -0 -n 1 -P "$(nproc)" bash -c 'try "$1"' _ | tee "$work/verdicts"
echo "$(spoiled | wc -l) spoiled, $(wc -l <"$work/verdicts") not turned red"
test ! -s "$work/verdicts"
