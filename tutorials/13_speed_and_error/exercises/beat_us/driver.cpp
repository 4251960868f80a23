// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

struct Velocities {
  double a, b, c, c_prime;
};

Velocities velocities(double alpha, long n);

int main() {
  return exercise::run_cases([](exercise::Case& one) {
    const double alpha = one.number();
    const Velocities v = velocities(alpha, one.whole());
    one.give(v.a);
    one.give(v.b);
    one.give(v.c);
    one.give(v.c_prime);
  });
}
