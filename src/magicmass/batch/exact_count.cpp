// SPDX-License-Identifier: MIT
#include "magicmass/batch/exact_count.hpp"

#include <cmath>
#include <optional>

#include "magicmass/counts.hpp"

namespace magicmass::batch {

void count_exactly(double alpha, std::int64_t* N_A, std::int64_t* N_B) {
  *N_A = *N_B = -1;
  if (!(alpha > 0.0 && std::isfinite(alpha))) return;
  if (const std::optional<Counts> counts = count_collisions(alpha)) {
    *N_A = counts->N_A;
    *N_B = counts->N_B;
  }
}

}  // namespace magicmass::batch
