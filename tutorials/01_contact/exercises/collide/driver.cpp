// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

struct Velocities {
  double first, second;
};
Velocities collide(double M_1, double u_1, double M_2, double u_2);

int main() {
  return exercise::run_cases([](exercise::Case& one) {
    const double M_1 = one.number();
    const double u_1 = one.number();
    const double M_2 = one.number();
    const double u_2 = one.number();
    const Velocities after = collide(M_1, u_1, M_2, u_2);
    one.give(after.first);
    one.give(after.second);
  });
}
