// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace magicmass {

/// Numbers of A-C and C-B collisions, the paper's N_A and N_B. Their sum is below 2^63.
struct Counts {
  std::int64_t N_A = 0;  ///< of A and C, at least 0
  std::int64_t N_B = 0;  ///< of C and B, at least 0

  /// Both are equal.
  friend bool operator==(const Counts&, const Counts&) = default;
};

/// Exact N_A and N_B for any double alpha > 0 (unit 1), at every threshold and as close to one as a double can be
/// (Ee & Lee Appendix sec:N-app; total = ceil(pi/h) - 1 with cos h = 1/(1+alpha)).
/// nullopt: N_A + N_B is 2^63 or more, which is so for alpha below about 5.8e-38.
/// Throws InvalidInput unless alpha is positive and finite; Undecided if 1536 bits did not separate alpha from a
/// threshold (no double is known to come near: see count.cpp).
std::optional<Counts> count_collisions(double alpha);

}  // namespace magicmass
