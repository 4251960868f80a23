// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

struct Counts {
  double N_A, N_B;
};
Counts count_collisions(double alpha);

int main() {
  return exercise::run_cases([](exercise::Case& one) {
    const Counts counts = count_collisions(one.number());
    one.give(counts.N_A);
    one.give(counts.N_B);
  });
}
