// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/last_collision.hpp"

#include "magicmass/counts.hpp"

namespace magicmass::report {

LastCollision last_collision(double alpha) {
  if (const auto counts = count_collisions(alpha)) return {counts->N_A, counts->N_B, true};
  constexpr std::int64_t far = std::int64_t{1} << 62U;
  return {far, far - 1, false};
}

}  // namespace magicmass::report
