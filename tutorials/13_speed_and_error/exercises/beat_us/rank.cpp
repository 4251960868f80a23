// SPDX-License-Identifier: GPL-2.0-or-later
#include "exercise_driver.hpp"

#include <chrono>
#include <vector>

#include "magicmass/velocities_closed.hpp"
#include "magicmass/velocities_product.hpp"
#include "magicmass/velocities_tangent.hpp"

struct Velocities {
  double a, b, c, c_prime;
};

Velocities velocities(double alpha, long n);

namespace {

struct Input {
  double alpha;
  long n;
};

template <class Function>
void play(exercise::Case& one, const std::vector<Input>& inputs, const Function& function) {
  constexpr int rounds = 4000;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < rounds; ++i)
    for (const Input& input : inputs) {
      const auto v = function(input.alpha, input.n);
      asm volatile("" : : "m"(v) : "memory");
    }
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  one.give(time.count() / rounds / static_cast<double>(inputs.size()));
  for (const Input& input : inputs) {
    const auto v = function(input.alpha, input.n);
    one.give(v.a);
    one.give(v.b);
    one.give(v.c);
    one.give(v.c_prime);
  }
  one.finish();
}

}  // namespace

int main() {
  namespace generated = magicmass::generated;
  exercise::Case one;
  std::vector<Input> inputs(static_cast<std::size_t>(one.whole()));
  for (Input& input : inputs) {
    input.alpha = one.number();
    input.n = one.whole();
  }
  play(one, inputs, velocities);
  play(one, inputs, [](double alpha, long n) { return generated::velocities_closed(alpha, n); });
  play(one, inputs, [](double alpha, long n) { return generated::velocities_product(alpha, n); });
  play(one, inputs, [](double alpha, long n) { return generated::velocities_tangent(alpha, n); });
}
