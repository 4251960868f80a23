// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "report/portable_random.hpp"

namespace magicmass::report {

/// Which index goes with an alpha.
enum class Pick {
  at_threshold,      ///< the cycle in which a_n and c'_n are nearly 0; the last collision
  around_threshold,  ///< next to it, the last ones, or any
  near_the_last,     ///< the last few, or any
  beyond_2_32,       ///< any above 2^32
  few,               ///< the first few, or as many bits as one likes
  ends,              ///< 0, 1, last - 1, last
  anywhere           ///< 0 to last, all alike
};

/// A mass ratio; k where it is near alpha_k or beta_k, else 0.
struct Alpha {
  double value;
  std::int64_t k = 0;
};

/// One kind of difficult mass ratio.
struct AlphaSource {
  std::string name;
  std::string description;
  std::uint64_t seed;
  Pick pick;
  std::vector<Alpha> (*draw)(PortableRandom& random, std::size_t size);
  bool has_count = true;  ///< false: the number of collisions is beyond 2^63
};

/// Hardest first.
const std::vector<AlphaSource>& alpha_sources();

}  // namespace magicmass::report
