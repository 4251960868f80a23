// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

double magic_ratio(double k);

int main() {
  return exercise::run_cases([](exercise::Case& one) { one.give(magic_ratio(one.number())); });
}
