// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/counts.hpp"

namespace magicmass {

/// Velocities after the last collision, in units of V, the counts that lead there, and the fraction rho = b_t^2 of the
/// energy that B takes (Ee & Lee eqs. eq:a-terminal, eq:b-terminal, eq:ct).
struct Terminal {
  Counts counts;  ///< the collisions that lead there
  double a_t;     ///< of A
  double b_t;     ///< of B
  double c_t;     ///< of the ball C
  double rho;     ///< b_t^2, from 0 to 1
};

}  // namespace magicmass
