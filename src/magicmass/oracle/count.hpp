// SPDX-License-Identifier: GPL-2.0-or-later
// How many collisions take place, from the collision law alone.
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>

namespace magicmass::oracle {

/// N_A and N_B, of any size.
struct Counts {
  cln::cl_I N_A;  ///< of A and C
  cln::cl_I N_B;  ///< of C and B

  friend bool operator==(const Counts&, const Counts&) = default;
};

/// Exact for rational alpha > 0 of any size, else throws std::invalid_argument; the cost grows with
/// log(1/alpha). Throws Undecided if a sign is open at 64 times the bits that alpha's size calls
/// for (never seen).
Counts count_collisions(const cln::cl_RA& alpha);

}  // namespace magicmass::oracle
