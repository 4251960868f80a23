// SPDX-License-Identifier: GPL-2.0-or-later
// A cheaper certified route than the oracle's, for millions of rows: the paper's sums of sines and
// cosines, typed in, on CLN's floats with a bound of their error. The product's evaluators are
// products of other angles. nullopt: not certain, ask the oracle.
#pragma once

#include <cstdint>
#include <optional>

#include "magicmass/numbers/values.hpp"

namespace magicmass::testing {
/// alpha <= 2^10, 1 <= n <= N_A.
std::optional<Velocities> velocities_by_formulas(double alpha, std::int64_t n);
/// alpha <= 2^10, N_A + N_B < 2^63.
std::optional<Terminal> terminal_by_formulas(double alpha);
}  // namespace magicmass::testing
