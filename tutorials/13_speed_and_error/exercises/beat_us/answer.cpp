// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

// The velocity of B after n cycles, in units of V.
// alpha = mass of C / mass of A or B.
double velocity_of_B(double alpha, long n) {
  return 0;  // change this
}
