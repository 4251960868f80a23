// SPDX-License-Identifier: GPL-2.0-or-later
struct Velocities {
  double a, b, c;
};

// The velocities after the first j collisions. A comes with 1, B and C are at
// rest; alpha = mass of C / mass of A or B.
// Collisions 1, 3, 5, ... are of A and C, collisions 2, 4, 6, ... of C and B.
Velocities after_collisions(double alpha, long j) {
  return {1, 0, 0};  // change this
}
