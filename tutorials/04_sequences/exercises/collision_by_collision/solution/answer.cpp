// SPDX-License-Identifier: GPL-2.0-or-later
struct Velocities {
  double a, b, c;
};

// The velocities after the first j collisions. A comes with 1, B and C are at
// rest; alpha = mass of C / mass of A or B.
// Collisions 1, 3, 5, ... are of A and C, collisions 2, 4, 6, ... of C and B.
Velocities after_collisions(double alpha, long j) {
  double a = 1, b = 0, c = 0;
  for (long i = 1; i <= j; ++i) {
    double& block = i % 2 == 1 ? a : b;
    const double common = (block + alpha * c) / (1 + alpha);
    block = 2 * common - block;
    c = 2 * common - c;
  }
  return {a, b, c};
}
