// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

struct Counts {
  double N_A, N_B;
};

// How often A and B collide with the ball; alpha = mass of C / mass of A or B.
Counts count_collisions(double alpha) {
  if (alpha == 1) return {3, 2};
  const double pi = 3.14159265358979323846;
  const double psi = 2 * std::atan(std::sqrt(alpha / (2 + alpha)));
  return {std::ceil(pi / psi - 0.5), std::ceil(pi / psi - 1)};
}
