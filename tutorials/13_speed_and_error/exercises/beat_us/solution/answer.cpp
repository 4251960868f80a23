// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

// The velocity of B after n cycles, in units of V.
// alpha = mass of C / mass of A or B.
double velocity_of_B(double alpha, long n) {
  const double psi = 4 * std::atan(std::sqrt(alpha / (2 + alpha)));
  return 2 * (1 + alpha) / (2 + alpha) * std::sin((n + 1) * psi / 2) *
         std::sin(n * psi / 2);
}
