// SPDX-License-Identifier: GPL-2.0-or-later
struct State {
  double a, b, c_prime;
};

// The velocities after one more cycle: A hits C, then C hits B.
// alpha = mass of C / mass of A or B.
State one_cycle(double alpha, State before) {
  return before;  // change this
}
