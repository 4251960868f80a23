// SPDX-License-Identifier: GPL-2.0-or-later
// The errors that the generated headers state, against exact rationals and certified digits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <catch2/catch.hpp>
#include <cln/integer.h>
#include <cln/real.h>

#include "magicmass/counts.hpp"
#include "magicmass/evaluators.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/ratios.hpp"
#include "magicmass/reference/velocities.hpp"

using namespace magicmass;

namespace {

struct Sample {
  double alpha;
  std::int64_t n;
};

// Log-uniform alpha; n near 0, near the last collision, and anywhere between.
std::vector<Sample> samples(double low, double high, int count) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(low, high);
  std::vector<Sample> all;
  for (int i = 0; i < count; ++i) {
    const auto alpha = static_cast<double>(
        static_cast<float>(std::pow(10, exponent(random))));  // exact in float too
    const std::int64_t last = count_collisions(alpha).value().N_A;
    const auto any = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(last + 1));
    const std::int64_t n[] = {any, std::max<std::int64_t>(0, last - i % 2),
                              std::min<std::int64_t>(last, i % 4)};
    all.push_back({alpha, n[i % 3]});
  }
  return all;
}

// Largest error of any velocity in eps times the largest velocity that its body has at that alpha: V for the
// blocks; for the ball the top of the sine in c_n, V_CM (1 + 1/sin(psi/4)).
// Beyond alpha = 1, where B and the ball are slow, in eps V.
template <class Real>
double largest_absolute_error(const generated::VelocityEvaluator<Real>& evaluator,
                              const std::vector<Sample>& at) {
  double largest = 0;
  for (const Sample& sample : at) {
    const auto got = evaluator.evaluate(static_cast<Real>(sample.alpha), sample.n);
    const auto exact = reference::velocities_within(MassRatio(sample.alpha),
                                                    cln::cl_I(static_cast<long>(sample.n)), 200);
    const double ball =
        std::max(1.0, (1 + std::sqrt(2 * (1 + sample.alpha) / sample.alpha)) / (2 + sample.alpha));
    const std::pair<Real, cln::cl_RA> pairs[] = {
        {got.a, exact.a}, {got.b, exact.b}, {got.c, exact.c}, {got.c_prime, exact.c_prime}};
    for (int which = 0; which < 4; ++which) {
      if (which == 2 && sample.n == 0) continue;
      const auto& [value, expected] = pairs[which];
      if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
      const double error = cln::double_approx(cln::abs(reference::exact(value) - expected));
      largest =
          std::max(largest, error / static_cast<double>(std::numeric_limits<Real>::epsilon()) /
                                (which < 2 ? 1 : ball));
    }
  }
  return largest;
}

}  // namespace

TEMPLATE_TEST_CASE("velocities keep the bounds that their forms promise", "[check]", float, double,
                   long double) {
  int promising = 0;
  for (const auto& evaluator : generated::velocity_evaluators<TestType>()) {
    if (evaluator.eps_bound == generated::no_bound) continue;
    INFO(evaluator.name);
    ++promising;
    CHECK(largest_absolute_error(evaluator, samples(-8, 0, 600)) <= evaluator.eps_bound);
    CHECK(largest_absolute_error(evaluator, samples(0, 8, 200)) <= evaluator.eps_bound);
    if (sizeof(TestType) > sizeof(float))
      CHECK(largest_absolute_error(evaluator, samples(-30, -8, 300)) <= evaluator.eps_bound);
  }
  CHECK(promising > 0);
}

TEST_CASE("the paper's forms would not keep them at large mass ratios: the bound can fail",
          "[exam]") {
  for (const auto& evaluator : generated::velocity_evaluators<double>())
    if (std::string(evaluator.form) == "closed")
      CHECK(largest_absolute_error(evaluator, samples(0, 8, 200)) > 1000);
}

namespace {

double largest_ratio_error(std::int64_t k, const generated::Ratios<double>& got) {
  return std::max(reference::ulp_error(got.magic, reference::ratio_within(Magic{k}, 200)),
                  reference::ulp_error(got.deficient, reference::ratio_within(Deficient{k}, 200)));
}

}  // namespace

TEST_CASE("ratios keep their bounds, and 1 ulp when long double is rounded", "[check]") {
  double rounded = 0, closed = 0;
  for (std::int64_t k = 1; k <= 100000; k += k < 100 ? 1 : 997) {
    for (const auto& evaluator : generated::ratio_evaluators<double>()) {
      const double error = largest_ratio_error(k, evaluator.evaluate(k));
      INFO(evaluator.name << " at k = " << k);
      CHECK(error <= evaluator.ulp_bound);
      if (std::string(evaluator.form) == "closed") closed = std::max(closed, error);
    }
    const auto in_long = generated::ratios_product<long double>(k);
    rounded = std::max(rounded, largest_ratio_error(k, {static_cast<double>(in_long.magic),
                                                        static_cast<double>(in_long.deficient)}));
  }
  CHECK(rounded <= 1);
  CHECK(closed > 1e6);  // sec x - 1 is not: the test can fail
}
