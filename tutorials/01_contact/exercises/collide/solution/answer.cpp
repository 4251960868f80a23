// SPDX-License-Identifier: GPL-2.0-or-later
struct Velocities {
  double first, second;
};

// Velocities after an elastic contact of masses M_1 and M_2 that come with
// u_1 and u_2.
Velocities collide(double M_1, double u_1, double M_2, double u_2) {
  const double common = (M_1 * u_1 + M_2 * u_2) / (M_1 + M_2);
  return {2 * common - u_1, 2 * common - u_2};
}
