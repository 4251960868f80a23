// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

struct State {
  double a, b, c_prime;
};
State one_cycle(double alpha, State before);

int main() {
  return exercise::run_cases([](exercise::Case& one) {
    const double alpha = one.number();
    State state{};
    state.a = one.number();
    state.b = one.number();
    state.c_prime = one.number();
    const State after = one_cycle(alpha, state);
    one.give(after.a);
    one.give(after.b);
    one.give(after.c_prime);
  });
}
