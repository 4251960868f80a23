// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "magicmass/quantities.hpp"

namespace magicmass {

/// The angle psi of one cycle, in rad: the double nearest to the exact value for every double alpha > 0. Throws
/// InvalidInput unless alpha is positive and finite; Undecided if 1536 bits did not settle the rounding (never seen).
double certified_angle(double alpha);

/// The magic and the deficient mass ratio alpha_k and beta_k, k >= 1: the doubles nearest to the exact values. Throws
/// InvalidInput for k < 1; Undecided as above.
generated::Ratios<double> certified_ratios(std::int64_t k);
double certified_magic(std::int64_t k);      ///< alpha_k alone.
double certified_deficient(std::int64_t k);  ///< beta_k alone.

}  // namespace magicmass
