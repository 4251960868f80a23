// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "magicmass/counts.hpp"

namespace magicmass {

/// A count and how it was decided.
struct CountDecision {
  std::optional<Counts> counts;  ///< as those of count_collisions
  /// pi/h was too close to an integer for long double: multiword arithmetic decided.
  bool near_tie = false;
};

/// count_collisions together with the way the answer was found.
CountDecision decide_count(double alpha);

}  // namespace magicmass
