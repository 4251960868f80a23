// SPDX-License-Identifier: GPL-2.0-or-later
// One n for all rows, on every instruction set of this machine, against the functions for one input.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "batch/instruction_sets.hpp"
#include "magicmass/accurate.hpp"
#include "magicmass/batch.hpp"
#include "magicmass/counts.hpp"
#include "random_numbers.hpp"

using namespace magicmass;

namespace {

struct Columns {
  std::vector<double> a, b, c, c_prime;
  explicit Columns(std::size_t size) : a(size), b(size), c(size), c_prime(size) {}
  bool operator==(const Columns&) const = default;
};

// alpha at random, at 0, 1 and the zeros of the first cycles' velocities and beside them; all with at least n collisions.
std::vector<double> mass_ratios(std::int64_t n, std::size_t size) {
  testing::Generator generator(80);
  std::vector<double> alphas;
  for (const double zero : {1.0, std::sqrt(5.0) - 2.0})
    for (double alpha : {std::nextafter(zero, 0.0), zero, std::nextafter(zero, 2.0)})
      alphas.push_back(alpha);
  for (const double extreme : {std::numeric_limits<double>::denorm_min(), 0x1p-121, 0x1p-119,
                               0x1p61, std::numeric_limits<double>::max()})
    alphas.push_back(extreme);
  while (alphas.size() < size) alphas.push_back(testing::log_uniform(generator, 1e-12, 1e3));
  std::erase_if(alphas, [n](double alpha) {
    const auto counts = count_collisions(alpha);
    return counts && counts->N_A < n;
  });
  return alphas;
}

Columns fast_columns(const std::vector<double>& alpha, std::int64_t n, InstructionSet set) {
  Columns got(alpha.size());
  fast::velocities(alpha, n, got.a, got.b, got.c, got.c_prime, set);
  return got;
}

}  // namespace

TEST_CASE("accurate velocities at one n are those of one input", "[check]") {
  for (const std::int64_t n : {0, 1, 2, 3, 7}) {
    const auto alpha = mass_ratios(n, 2003);
    REQUIRE(alpha.size() > 300);
    for (const InstructionSet set : testing::available_instruction_sets()) {
      Columns got(alpha.size());
      accurate::velocities(alpha, n, got.a, got.b, got.c, got.c_prime, set);
      for (std::size_t i = 0; i < alpha.size(); ++i) {
        const auto one = accurate::velocities(alpha[i], n);
        INFO(to_text(set) << ", n = " << n << ", alpha = " << alpha[i]);
        REQUIRE(got.a[i] == one.a);
        REQUIRE(got.b[i] == one.b);
        REQUIRE(got.c[i] == one.c);
        REQUIRE(got.c_prime[i] == one.c_prime);
      }
    }
  }
}

TEST_CASE("fast velocities at one n are within an ulp, and the same bits everywhere", "[check]") {
  const auto is_near = [](double x, double exact) {
    return std::fabs(x - exact) <= std::fabs(std::nextafter(exact, HUGE_VAL) - exact);
  };
  for (const std::int64_t n : {1, 2}) {
    const auto alpha = mass_ratios(n, 2003);
    const Columns expected = fast_columns(alpha, n, InstructionSet::baseline);
    for (const InstructionSet set : testing::available_instruction_sets())
      CHECK(fast_columns(alpha, n, set) == expected);
    for (std::size_t i = 0; i < alpha.size(); ++i) {
      if (alpha[i] < 0x1p-120 || alpha[i] > 0x1p60) continue;
      const auto exact = accurate::velocities(alpha[i], n);
      INFO("n = " << n << ", alpha = " << alpha[i]);
      REQUIRE(is_near(expected.a[i], exact.a));
      REQUIRE(is_near(expected.b[i], exact.b));
      REQUIRE(is_near(expected.c[i], exact.c));
      REQUIRE(is_near(expected.c_prime[i], exact.c_prime));
    }
  }
}

TEST_CASE("no velocity at one n for a mass ratio that is none", "[exam]") {
  const std::vector<double> alpha{0.5,
                                  -1.0,
                                  0.0,
                                  std::numeric_limits<double>::quiet_NaN(),
                                  std::numeric_limits<double>::infinity(),
                                  0.25};
  for (const InstructionSet set : testing::available_instruction_sets())
    for (const std::int64_t n : {0, 1, 2, 5}) {
      const Columns got = fast_columns(alpha, n, set);
      for (std::size_t i = 1; i < 5; ++i) CHECK(std::isnan(got.a[i]));
    }
  for (const double a : fast_columns(alpha, -1, InstructionSet::baseline).a) CHECK(std::isnan(a));
}
