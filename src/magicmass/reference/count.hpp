// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass::reference {

/// N_A and N_B, of any size.
struct LargeCounts {
  cln::cl_I N_A;  ///< of A and C
  cln::cl_I N_B;  ///< of C and B
};

/// Exact numbers of A-C and C-B collisions for rational alpha > 0 of any size, from the collision law alone; the
/// cost grows with log(1/alpha). Throws InvalidInput for alpha <= 0; Undecided if a sign stayed open at
/// a precision far beyond what alpha's size calls for (never seen).
LargeCounts count_collisions(const cln::cl_RA& alpha);

/// Of any mass ratio; at magic:k and deficient:k by the theorems counting.N_A and counting.N_B. Throws as above, and as
/// magicmass::count_collisions.
LargeCounts count_collisions(const MassRatio& alpha);

}  // namespace magicmass::reference
