// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

struct Velocities {
  double a, b, c;
};
Velocities after_collisions(double alpha, long j);

int main() {
  return exercise::run_cases([](exercise::Case& one) {
    const double alpha = one.number();
    const long j = one.whole();
    one.whole();  // the place in the list of events, for the oracle
    const Velocities after = after_collisions(alpha, j);
    one.give(after.a);
    one.give(after.b);
    one.give(after.c);
  });
}
