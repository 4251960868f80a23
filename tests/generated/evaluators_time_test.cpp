// SPDX-License-Identifier: GPL-2.0-or-later
// How fast the forms are, as ratios to the paper's form in the same run. Measures and reports; the one check
// is that there is something to report. `ctest -L time` runs it, CI does not.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

#include "magicmass/evaluators.hpp"

using namespace magicmass;

namespace {

struct Input {
  double alpha;
  std::int64_t n;
};

std::vector<Input> everyday() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-4, 0);
  std::vector<Input> inputs;
  for (int i = 0; i < 1000; ++i)
    inputs.push_back({std::pow(10, exponent(random)), static_cast<std::int64_t>(random() % 20)});
  return inputs;
}

double nanoseconds_each(const generated::VelocityEvaluator<double>& evaluator,
                        const std::vector<Input>& inputs) {
  const auto start = std::chrono::steady_clock::now();
  double sum = 0;
  for (const Input& input : inputs) {
    const auto v = evaluator.evaluate(input.alpha, input.n);
    sum += v.a + v.b + v.c + v.c_prime;
  }
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
  REQUIRE(std::isfinite(sum));  // and so the loop is not thrown away
  return time.count() / static_cast<double>(inputs.size());
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

}  // namespace

TEST_CASE("velocities: time of each form, and its ratio to the paper's form", "[time]") {
  const std::vector<Input> inputs = everyday();
  const auto& evaluators = generated::velocity_evaluators<double>();
  std::vector<std::vector<double>> times(evaluators.size()), ratios(evaluators.size());
  for (int round = 0; round < 51; ++round) {
    std::vector<double> now;
    for (const auto& evaluator : evaluators) now.push_back(nanoseconds_each(evaluator, inputs));
    for (std::size_t i = 0; i < now.size(); ++i) {
      times[i].push_back(now[i]);
      ratios[i].push_back(now[i] / now[0]);  // the first is the paper's
    }
  }
  for (std::size_t i = 0; i < evaluators.size(); ++i)
    WARN(evaluators[i].name << ": median " << median(times[i]) << " ns, least "
                            << *std::min_element(times[i].begin(), times[i].end())
                            << " ns, paired ratio " << median(ratios[i]));
  CHECK(evaluators.size() > 1);
}
