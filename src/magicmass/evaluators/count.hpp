// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "magicmass/counts.hpp"

namespace magicmass {

/// Exact N_A and N_B for any double alpha > 0 (unit 1), at every threshold and as close to one as a double can be
/// (Ee & Lee Appendix sec:N-app; total = ceil(pi/h) - 1 with cos h = 1/(1+alpha)).
/// nullopt: N_A + N_B is 2^63 or more, which is so for alpha below about 5.8e-38.
/// Throws InvalidInput unless alpha is positive and finite; Undecided if 1536 bits did not separate alpha from a
/// threshold (no double is known to come near: see count.cpp).
std::optional<Counts> count_collisions(double alpha);

/// A count and how it was decided.
struct CountDecision {
  std::optional<Counts> counts;  ///< as those of count_collisions
  bool near_tie =
      false;  ///< pi/h was too close to an integer for long double: multiword arithmetic decided
};

/// count_collisions together with the way the answer was found.
CountDecision decide_count(double alpha);

}  // namespace magicmass
