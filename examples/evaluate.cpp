// SPDX-License-Identifier: MIT
// Velocities just after the second collisions, in both tiers: one mass ratio, and many at once.
#include <cstdio>
#include <vector>

#include "magicmass/accurate.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/fast.hpp"

int main() {
  const auto one =
      magicmass::fast::velocities(0.12, 2);  // alpha = m/M, n; velocities in units of V
  const auto nearest = magicmass::accurate::velocities(0.12, 2);  // each the nearest double
  std::printf("a_2 = %.6f, b_2 = %.6f; %.17g\n", one.a, one.b, nearest.b);

  const std::vector<double> alpha{0.1, 0.2, 0.3};
  std::vector<double> a(3), b(3), c(3), c_prime(3);
  magicmass::fast::velocities(alpha, 1, a, b, c, c_prime);
  for (std::size_t i = 0; i < 3; ++i) std::printf("alpha = %g: b_1 = %.6f\n", alpha[i], b[i]);
}
