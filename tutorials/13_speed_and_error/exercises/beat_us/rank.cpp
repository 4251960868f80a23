// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

#include <chrono>
#include <vector>

#include "magicmass/velocities_closed.hpp"
#include "magicmass/velocities_product.hpp"
#include "magicmass/velocities_tangent.hpp"

double velocity_of_B(double alpha, long n);

namespace {

struct Input {
  double alpha;
  long n;
};

template <class Function>
void play(exercise::Case& one, const std::vector<Input>& inputs, const Function& function) {
  constexpr int rounds = 4000;
  volatile double sink = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < rounds; ++i)
    for (const Input& input : inputs) sink = function(input.alpha, input.n);
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  one.give(time.count() / rounds / static_cast<double>(inputs.size()));
  for (const Input& input : inputs) one.give(function(input.alpha, input.n));
  one.finish();
}

}  // namespace

int main() {
  exercise::Case one;
  std::vector<Input> inputs(static_cast<std::size_t>(one.whole()));
  for (Input& input : inputs) {
    input.alpha = one.number();
    input.n = one.whole();
  }
  play(one, inputs, velocity_of_B);
  play(one, inputs, [](double alpha, long n) { return magicmass::generated::b_closed(alpha, n); });
  play(one, inputs, [](double alpha, long n) { return magicmass::generated::b_product(alpha, n); });
  play(one, inputs, [](double alpha, long n) { return magicmass::generated::b_tangent(alpha, n); });
}
