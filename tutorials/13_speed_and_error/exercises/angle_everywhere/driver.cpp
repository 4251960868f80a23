// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

double angle(double alpha);

int main() {
  return exercise::run_cases([](exercise::Case& one) { one.give(angle(one.number())); });
}
