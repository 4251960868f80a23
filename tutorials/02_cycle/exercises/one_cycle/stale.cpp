// SPDX-License-Identifier: GPL-2.0-or-later
struct State {
  double a, b, c_prime;
};

// The velocities after one more cycle: A hits C, then C hits B.
// alpha = mass of C / mass of A or B.
State one_cycle(double alpha, State before) {
  State after{};
  const double c = before.c_prime;
  after.a = ((1 - alpha) * before.a + 2 * alpha * before.c_prime) / (1 + alpha);
  after.b = ((1 - alpha) * before.b + 2 * alpha * c) / (1 + alpha);
  after.c_prime = (2 * before.b - (1 - alpha) * c) / (1 + alpha);
  return after;
}
