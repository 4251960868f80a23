// SPDX-License-Identifier: GPL-2.0-or-later
// Tier accurate: the double nearest to the oracle's value on every family of hard inputs, and at the hardest of them.
#include "magicmass/accurate.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

#include "magicmass/counts.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/evaluators/certified_velocities.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/reference/velocities.hpp"
#include "magicmass/scenes/mass_ratio.hpp"
#include "random_numbers.hpp"
#include "report/family.hpp"
#include "report/oracle.hpp"
#include "tiers/exact_terminal.hpp"

using namespace magicmass;
using report::ExactValue;
using report::Input;

namespace {

std::string place(const Input& input) {
  return "alpha = " + to_text(MassRatio(input.alpha)) + ", index " + std::to_string(input.index);
}

std::vector<double> accurate_values(const std::string& quantity, const Input& input) {
  if (quantity == "velocities") {
    const auto v = accurate::velocities(input.alpha, input.index);
    return {v.a, v.b, v.c, v.c_prime};
  }
  if (quantity == "encounters") {
    const auto one = accurate::encounters(input.alpha, input.index);
    return {one.t, one.s};
  }
  if (quantity == "angle") return {accurate::angle(input.alpha)};
  const auto one = accurate::ratios(input.index);
  return {one.magic, one.deficient};
}

/// How many members of how many inputs are not the nearest double.
int misrounded(const std::vector<double>& got, const std::vector<ExactValue>& exact) {
  int wrong = 0;
  for (std::size_t i = 0; i < got.size(); ++i)
    wrong += exact[i].exists && got[i] != exact[i].nearest_double ? 1 : 0;
  return wrong;
}

void require_nearest(const std::string& quantity, std::size_t size) {
  report::Oracle oracle;
  for (const report::Family& family : report::families(quantity, size))
    for (const Input& input : family.inputs) {
      INFO(quantity << ", " << family.name << ": " << place(input));
      REQUIRE(misrounded(accurate_values(quantity, input), oracle.at(quantity, input)) == 0);
    }
}

bool is_nearest_terminal(report::Oracle& oracle, double alpha) {
  const auto got = accurate::terminal(alpha);
  const auto exact = testing::exact_terminal(oracle, alpha);
  if (!got || !exact) return !got && !exact;
  return got->counts == exact->counts &&
         misrounded({got->a_t, got->b_t, got->c_t, got->rho},
                    {exact->a_t, exact->b_t, exact->c_t, exact->rho}) == 0;
}

}  // namespace

TEST_CASE("accurate velocities are the nearest doubles on every family", "[check]") {
  require_nearest("velocities", 80);
}

TEST_CASE("accurate times and distances are the nearest doubles on every family", "[check]") {
  require_nearest("encounters", 150);
}

TEST_CASE("accurate angles and ratios are the nearest doubles on every family", "[check]") {
  require_nearest("angle", 200);
  require_nearest("ratios", 400);
}

TEST_CASE("one digit of the last place would be seen", "[exam]") {
  report::Oracle oracle;
  const auto& exact = oracle.at("velocities", {0.01, 3});
  auto got = accurate_values("velocities", {0.01, 3});
  CHECK(misrounded(got, exact) == 0);
  got[2] = std::nextafter(got[2], 2.0);
  CHECK(misrounded(got, exact) == 1);
}

TEST_CASE("alpha = 2^j - 1: velocities exactly representable or halfway, t_1 = s_1 too", "[exam]") {
  int exact_ones = 0;
  for (int j = 1; j <= 53; ++j) {
    const double alpha = std::ldexp(1.0, j) - 1;
    INFO("alpha = 2^" << j << " - 1");
    for (const std::int64_t n : {0, 1}) {
      const auto exact = reference::exact_velocities(reference::exact(alpha), n);
      const auto got = accurate::velocities(alpha, n);
      CHECK(got.a == reference::nearest<double>(exact.a));
      CHECK(got.b == reference::nearest<double>(exact.b));
      CHECK(got.c == reference::nearest<double>(exact.c));
      CHECK(got.c_prime == reference::nearest<double>(exact.c_prime));
      exact_ones += reference::exact(got.b) == exact.b ? 1 : 0;
    }
    const auto first = accurate::encounters(alpha, 1);
    CHECK((first.t == std::ldexp(1.0, j - 1) && first.s == first.t));
    report::Oracle oracle;
    CHECK(is_nearest_terminal(oracle, alpha));
  }
  CHECK(exact_ones > 60);
}

TEST_CASE("t_1 = s_1 = (1 + alpha)/2 is rounded to even where it is halfway", "[check]") {
  testing::Generator generator(81);
  for (int i = 0; i < 2000; ++i) {
    // few digits, far from those of 1
    const double alpha = std::ldexp(static_cast<double>(testing::whole(generator, 0, 15) * 2 + 1),
                                    static_cast<int>(testing::whole(generator, -60, 60)));
    const double half = reference::nearest<double>((1 + reference::exact(alpha)) / 2);
    INFO(place({alpha, 1}));
    REQUIRE((accurate::encounters(alpha, 1).t == half && accurate::encounters(alpha, 1).s == half));
  }
}

TEST_CASE("the ends of the doubles, and the ranges of the kernels", "[exam]") {
  report::Oracle oracle;
  constexpr double largest = std::numeric_limits<double>::max();
  for (const double end : {std::numeric_limits<double>::denorm_min(), 0x1p-1022, 0x1p-900, 0x1p-120,
                           0x1p60, 0x1p400, 1.0, largest}) {
    for (const double alpha :
         {std::nextafter(end, 0.0), end, end == largest ? end : std::nextafter(end, HUGE_VAL)}) {
      if (alpha == 0.0) continue;
      INFO(place({alpha, 0}));
      CHECK(is_nearest_terminal(oracle, alpha));
      CHECK(accurate::angle(alpha) == oracle.at("angle", {alpha, 0})[0].nearest_double);
      const bool is_small = alpha < 0x1p-100;
      constexpr std::int64_t two_51 = std::int64_t{1} << 51U;
      for (const std::int64_t n : {std::int64_t{0}, std::int64_t{1}, std::int64_t{2}, two_51 - 1,
                                   two_51, two_51 + 1, 4 * two_51 + 1}) {
        if (n > 1 && !is_small) continue;
        INFO("n = " << n);
        CHECK(misrounded(accurate_values("velocities", {alpha, n}),
                         oracle.at("velocities", {alpha, n})) == 0);
        CHECK(misrounded(accurate_values("encounters", {alpha, n}),
                         oracle.at("encounters", {alpha, n})) == 0);
      }
    }
  }
}

TEST_CASE("past the last collision the formulas go on, as certified arithmetic has them",
          "[check]") {
  for (const double alpha : {0.9, 0.1, 0.01, 1e-4}) {
    const std::int64_t N_A = count_collisions(alpha)->N_A;
    for (std::int64_t n = N_A; n <= 12 * N_A + 9; n += 1 + N_A / 40) {
      const auto got = accurate::velocities(alpha, n);
      const auto expected = certified_velocities(alpha, n);
      INFO(place({alpha, n}));
      REQUIRE((got.a == expected.a && got.b == expected.b && got.c == expected.c &&
               got.c_prime == expected.c_prime));
    }
  }
}

TEST_CASE("accurate functions refuse what has no answer with one line", "[exam]") {
  const double nan = std::nan(""), infinity = HUGE_VAL;
  for (const double alpha : {0.0, -0.0, -1.0, nan, infinity, -infinity}) {
    CHECK_THROWS_AS(accurate::velocities(alpha, 1), InvalidInput);
    CHECK_THROWS_AS(accurate::velocities(alpha, 0), InvalidInput);
    CHECK_THROWS_AS(accurate::encounters(alpha, 0), InvalidInput);
    CHECK_THROWS_AS(accurate::encounters(alpha, 2), InvalidInput);
    CHECK_THROWS_AS(accurate::terminal(alpha), InvalidInput);
    CHECK_THROWS_AS(accurate::angle(alpha), InvalidInput);
  }
  CHECK_THROWS_WITH(accurate::velocities(-0.1, 1),
                    "alpha must be a positive finite number, got -0.1");
  CHECK_THROWS_WITH(accurate::velocities(0.1, -1), "n must be 0 or more, got -1");
  CHECK_THROWS_WITH(accurate::encounters(0.1, -1), "j must be 0 or more, got -1");
  CHECK_THROWS_WITH(accurate::encounters(0.1, 7),
                    "j must be below the number of collisions, 7, got 7");
  CHECK_THROWS_WITH(accurate::encounters(3.0, 2),
                    "j must be below the number of collisions, 2, got 2");
  for (const double x : {0.9, 0.1, 1e-3}) {
    const Counts counts = count_collisions(x).value();
    for (std::int64_t j = counts.N_A + counts.N_B; j < 20 * counts.N_A; ++j)
      CHECK_THROWS_AS(accurate::encounters(x, j), InvalidInput);
  }
  CHECK_THROWS_WITH(accurate::ratios(0), "k must be 1 or more, got 0");
}
