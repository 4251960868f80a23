// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

struct Counts {
  double N_A, N_B;
};

// How often A and B collide with the ball; alpha = mass of C / mass of A or B.
Counts count_collisions(double alpha) {
  return {1, 1};  // change this
}
