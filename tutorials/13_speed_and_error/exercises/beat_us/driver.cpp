// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

double velocity_of_B(double alpha, long n);

int main() {
  return exercise::run_cases([](exercise::Case& one) {
    const double alpha = one.number();
    one.give(velocity_of_B(alpha, one.whole()));
  });
}
