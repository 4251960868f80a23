// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

namespace magicmass {

/// The magic or deficient mass ratio closest to some alpha, and how close that is.
struct NearestThreshold {
  bool is_magic = true;  ///< alpha_k, else beta_k
  std::int64_t k = 1;    ///< its number, from 1 on
  double distance = 0;   ///< (alpha - threshold)/threshold, correctly rounded
};

/// What a near tie is near to: for every double alpha whose count fits 63 bits, else nullopt. Some microseconds. Throws
/// as count_collisions does.
std::optional<NearestThreshold> nearest_threshold(double alpha);

}  // namespace magicmass
