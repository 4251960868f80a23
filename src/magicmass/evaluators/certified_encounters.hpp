// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "magicmass/quantities.hpp"

namespace magicmass {

/// Time t_j, in units of L/V, and distance s_j of A and B, in units of L, at collision j = 0 (P_1), 1 (Q_1), 2 (P_2),
/// ...: each the double nearest to the exact value, ties to even, for every double alpha > 0 and every collision.
/// Throws InvalidInput unless alpha is positive and finite and 0 <= j < number of collisions; Undecided if 1536 bits
/// did not settle a rounding (never seen: see encounter_attempts.hpp).
generated::Encounters<double> certified_encounters(double alpha, std::int64_t j);

}  // namespace magicmass
