// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

struct Velocities {
  double a, b, c, c_prime;
};

// The velocities after cycle n, in units of V, and the ball's before and after
// it meets B. alpha = mass of C / mass of A or B.
Velocities velocities(double alpha, long n) {
  return {1, 0, 0, 0};  // change this
}
