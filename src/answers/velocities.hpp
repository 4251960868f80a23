// SPDX-License-Identifier: GPL-2.0-or-later
// eval, count, terminal and ratios.
#pragma once

#include "answers/request.hpp"

namespace answers {

/// Velocities after n cycles: options alpha, n, tier (fast, accurate, exact), digits. Throws
/// InvalidInput for n above N_A, Undecided for exact fractions that would be too long. Columns a
/// and c: just after P_n, in units of V; b and c_prime: just after Q_n.
Answer eval(const Request& request);
Names eval_columns(const Request& request);

Answer count(const Request& request);
Names count_columns(const Request& request);

/// Terminal velocities in units of V and rho, B's share of the energy: options alpha, tier, digits,
/// restitution. Where collisions never end, collapse_time is when they do, in units of L/V, and the
/// velocities are from then on; exact fractions throw Undecided there.
Answer terminal(const Request& request);
Names terminal_columns(const Request& request);

/// Magic and deficient mass ratios 1 to count, as doubles or with digits, in radicals where the
/// book has them; many are written as they come.
Answer ratios(const Request& request);

}  // namespace answers
