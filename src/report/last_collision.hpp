// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>

namespace magicmass::report {

/// Numbers of collisions, or 2^62 each where they are not below 2^63 together: no input goes further.
struct LastCollision {
  std::int64_t N_A;
  std::int64_t N_B;
  bool is_known;  ///< false: the true numbers are larger

  std::int64_t total() const { return N_A + N_B; }
};

/// Says which inputs have a meaning, by the certified count, which is itself measured against the reference.
LastCollision last_collision(double alpha);

}  // namespace magicmass::report
