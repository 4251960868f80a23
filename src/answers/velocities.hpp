// SPDX-License-Identifier: GPL-2.0-or-later
// eval, count, terminal and ratios.
#pragma once

#include "answers/request.hpp"

namespace answers {

/// Velocities after n cycles: options alpha, n, tier (fast, accurate, exact), digits. Throws
/// InvalidInput for n above N_A, Undecided for exact fractions that would be too long.
Answer eval(const Request& request);
std::vector<Column> eval_columns();

Answer count(const Request& request);
std::vector<Column> count_columns();

/// Terminal velocities: options alpha, tier, digits.
Answer terminal(const Request& request);
std::vector<Column> terminal_columns();

/// Magic and deficient mass ratios 1 to count, as doubles or with digits, in radicals where the
/// book has them.
Answer ratios(const Request& request);
std::vector<Column> ratios_columns();

}  // namespace answers
