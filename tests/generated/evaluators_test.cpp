// SPDX-License-Identifier: GPL-2.0-or-later
// What can be seen with floating point alone: every evaluator in the tables, at every precision.
#include "magicmass/evaluators.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

#include "magicmass/counts.hpp"

using namespace magicmass;
using Catch::Matchers::WithinAbs;

TEMPLATE_TEST_CASE("at n = 0 only A moves, with V", "[exam]", float, double, long double) {
  for (const auto& evaluator : generated::velocity_evaluators<TestType>())
    for (const TestType alpha : {TestType(1e-6), TestType(0.1), TestType(1), TestType(7)}) {
      INFO(evaluator.name << " at alpha = " << alpha);
      const generated::Velocities<TestType> start = evaluator.evaluate(alpha, 0);
      // The ball's velocities carry the factor 1/sin(psi/4): their rounding is that of 1/sqrt(alpha) at most.
      const double unit = 8 * static_cast<double>(std::numeric_limits<TestType>::epsilon());
      const double ball = unit / std::sqrt(static_cast<double>(alpha));
      CHECK_THAT(static_cast<double>(start.a), WithinAbs(1, unit));
      CHECK_THAT(static_cast<double>(start.b), WithinAbs(0, unit));
      CHECK_THAT(static_cast<double>(start.c), WithinAbs(0, ball));
      CHECK_THAT(static_cast<double>(start.c_prime), WithinAbs(0, ball));
    }
}

TEMPLATE_TEST_CASE("momentum and energy stay what they were", "[check]", float, double,
                   long double) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-6, 1);
  for (const auto& evaluator : generated::velocity_evaluators<TestType>())
    for (int i = 0; i < 300; ++i) {
      const auto alpha = static_cast<TestType>(std::pow(10, exponent(random)));
      const std::int64_t last = count_collisions(static_cast<double>(alpha)).value().N_B;
      const std::int64_t n =
          1 + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(last));
      const generated::Velocities<TestType> v = evaluator.evaluate(alpha, n);
      INFO(evaluator.name << " at alpha = " << alpha << ", n = " << n);
      // Four roundings of size eps times sizes up to 1 (blocks) and 1/sqrt(alpha) (ball, weighed with alpha).
      const double bound = 64 * static_cast<double>(std::numeric_limits<TestType>::epsilon());
      CHECK_THAT(static_cast<double>(v.a + v.b + alpha * v.c_prime), WithinAbs(1, bound));
      CHECK_THAT(static_cast<double>(v.a * v.a + v.b * v.b + alpha * v.c_prime * v.c_prime),
                 WithinAbs(1, bound));
    }
}

TEST_CASE("psi as a double is psi as a long double as closely as is promised", "[check]") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int i = 0; i < 2000; ++i) {
    const double alpha = std::pow(10, exponent(random));
    const auto expected = generated::angle_product<long double>(alpha);
    for (const auto& evaluator : generated::angle_evaluators<double>()) {
      const double got = evaluator.evaluate(alpha);
      INFO(evaluator.name << " at alpha = " << alpha);
      const long double ulp =
          std::nextafter(std::abs(got), std::numeric_limits<double>::infinity()) - std::abs(got);
      CHECK(std::abs(got - expected) <= evaluator.ulp_bound * ulp);
    }
  }
}
