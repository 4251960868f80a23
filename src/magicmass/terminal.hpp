// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/counts.hpp"

namespace magicmass {

/// Velocities after the last collision, in units of V, the counts that lead there, and the fraction rho = b_t^2 of the
/// energy that B takes (Ee & Lee eqs. eq:at to eq:ct).
struct Terminal {
  Counts counts;
  double a_t;
  double b_t;
  double c_t;
  double rho;
};

}  // namespace magicmass
