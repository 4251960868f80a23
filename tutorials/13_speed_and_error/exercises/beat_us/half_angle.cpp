// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

struct Velocities {
  double a, b, c, c_prime;
};

// The velocities after cycle n, in units of V, and the ball's before and after
// it meets B. alpha = mass of C / mass of A or B.
Velocities velocities(double alpha, long n) {
  const double half = std::atan(std::sqrt(alpha / (2 + alpha)));  // psi/2
  const double twice = 2 / (2 + alpha);  // two times V_CM
  const double late = std::cos((n + 0.5) * half);
  const double early = std::cos((n - 0.5) * half);
  const double sine = std::sin(n * half);
  const double ball = twice * sine / std::sin(half / 2);
  return {twice * (1 + alpha) * late * early,
          twice * (1 + alpha) * std::sin((n + 1) * half) * sine, ball * early,
          -ball * late};
}
