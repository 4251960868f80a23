// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace magicmass {

/// Numbers of A-C and C-B collisions, the paper's N_A and N_B. Their sum is below 2^63.
struct Counts {
  std::int64_t N_A = 0;  ///< of A and C, at least 0
  std::int64_t N_B = 0;  ///< of C and B, at least 0

  /// Both are equal.
  friend bool operator==(const Counts&, const Counts&) = default;
};

}  // namespace magicmass
