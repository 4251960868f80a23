// SPDX-License-Identifier: MIT
// Collisions, counted exactly for any double, and the threshold that alpha is closest to.
#include <cstdio>

#include "magicmass/counts.hpp"
#include "magicmass/nearest_threshold.hpp"

int main() {
  const double alpha = 0x1.1c7397cb68b7ep-18;  // hardly above the 539th magic mass ratio
  const auto counts = magicmass::count_collisions(alpha).value();  // none from 2^63 collisions on
  const auto threshold = magicmass::nearest_threshold(alpha).value();
  std::printf("N_A = %d, N_B = %d\n", int(counts.N_A), int(counts.N_B));
  std::printf("%s ratio %d is %.1e away\n", threshold.is_magic ? "magic" : "deficient",
              int(threshold.k), threshold.distance);
}
