// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

double ladder(double x, long m);

int main() {
  return exercise::run_cases([](exercise::Case& one) {
    const double x = one.number();
    one.give(ladder(x, one.whole()));
  });
}
