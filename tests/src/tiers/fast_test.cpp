// SPDX-License-Identifier: GPL-2.0-or-later
// Tier fast: at most 4 times what rounding alpha alone would cost, on every family of hard inputs.
#include "magicmass/fast.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

#include "magicmass/counts.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/mass_ratio.hpp"
#include "random_numbers.hpp"
#include "report/family.hpp"
#include "report/oracle.hpp"

using namespace magicmass;
using report::ExactValue;
using report::Input;

namespace {

constexpr double allowed = 4.0;  // stated in fast.hpp

std::vector<double> fast_values(const std::string& quantity, const Input& input) {
  if (quantity == "velocities") {
    const auto v = fast::velocities(input.alpha, input.index);
    return {v.a, v.b, v.c, v.c_prime};
  }
  if (quantity == "encounters") {
    const auto one = fast::encounters(input.alpha, input.index);
    return {one.t, one.s};
  }
  if (quantity == "angle") return {fast::angle(input.alpha)};
  const auto one = fast::ratios(input.index);
  return {one.magic, one.deficient};
}

/// The largest error over the envelope; where the value is 0, anything else is infinitely wrong.
double over_envelope(const std::vector<double>& got, const std::vector<ExactValue>& exact) {
  double worst = 0.0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    if (!exact[i].exists) continue;
    const auto one = report::deviation(got[i], exact[i]);
    if (exact[i].high == 0 && got[i] != 0.0) return HUGE_VAL;
    worst = std::max(worst, std::isnan(got[i]) ? HUGE_VAL : one.over_envelope);
  }
  return worst;
}

double worst_of(const std::string& quantity, std::size_t size) {
  report::Oracle oracle;
  double worst = 0.0;
  for (const report::Family& family : report::families(quantity, size))
    for (const Input& input : family.inputs) {
      INFO(quantity << ", " << family.name << ": alpha = " << to_text(MassRatio(input.alpha))
                    << ", index " << input.index);
      const double one = over_envelope(fast_values(quantity, input), oracle.at(quantity, input));
      REQUIRE(one <= allowed);
      worst = std::max(worst, one);
    }
  return worst;
}

}  // namespace

TEST_CASE("fast velocities are within 4 envelopes on every family", "[check]") {
  CHECK(worst_of("velocities", 80) > 0.9);  // a rounding is there, so the measure sees it
}

TEST_CASE("fast times, distances, angles and ratios are within 4 envelopes on every family",
          "[check]") {
  CHECK(worst_of("encounters", 120) > 0.9);
  CHECK(worst_of("angle", 150) > 0.9);
  CHECK(worst_of("ratios", 400) > 0.9);
}

TEST_CASE("fast ratios are within an ulp", "[check]") {
  report::Oracle oracle;
  for (const report::Family& family : report::families("ratios", 400))
    for (const Input& input : family.inputs) {
      const auto got = fast::ratios(input.index);
      const auto& exact = oracle.at("ratios", input);
      INFO("k = " << input.index);
      REQUIRE(report::deviation(got.magic, exact[0]).ulp <= 1.0);
      REQUIRE(report::deviation(got.deficient, exact[1]).ulp <= 1.0);
    }
}

TEST_CASE("the last times and distances of many are as good as the others", "[check]") {
  report::Oracle oracle;
  testing::Generator generator(85);
  for (int i = 0; i < 150; ++i) {
    const double alpha = testing::log_uniform(generator, 1e-25, 1e-5);
    const Counts counts = count_collisions(alpha).value();
    const std::int64_t last = counts.N_A + counts.N_B - 1;
    for (const std::int64_t j : {last, last - 1, last - last / 10000 - 1, last - last / 3000}) {
      INFO("alpha = " << to_text(MassRatio(alpha)) << ", j = " << j << " of " << last);
      REQUIRE(over_envelope(fast_values("encounters", {alpha, j}),
                            oracle.at("encounters", {alpha, j})) <= allowed);
    }
  }
}

TEST_CASE("few collisions at large angles, where a rounding of the angle shows most", "[exam]") {
  report::Oracle oracle;
  for (const Input& input : {Input{0x1.8662e53d88de6p-2, 1}, Input{0x1.ffe02ebc6c882p-1, 2},
                             Input{0x1.ff83ff14d23e6p-1, 2}, Input{0x1.ffffffffffc16p-1, 2}})
    CHECK(over_envelope(fast_values("velocities", input), oracle.at("velocities", input)) <= 3.0);
}

TEST_CASE("an error of 5 envelopes would be seen", "[exam]") {
  report::Oracle oracle;
  const auto& exact = oracle.at("velocities", {0.01, 3});
  auto got = fast_values("velocities", {0.01, 3});
  CHECK(over_envelope(got, exact) <= allowed);
  got[1] *= 1 + 0x1p-48;
  CHECK(over_envelope(got, exact) > allowed);
  got[1] = std::nan("");
  CHECK(over_envelope(got, exact) > allowed);
}

TEST_CASE("the ends of the doubles, and n beyond 2^51 and 2^53", "[exam]") {
  report::Oracle oracle;
  constexpr double largest = std::numeric_limits<double>::max();
  for (const double alpha : {5e-324, 0x1p-1022, 0x1p-900, 1e-200, 1e-35, 0x1p60, 0x1p400, largest,
                             std::nextafter(1.0, 0.0), 1.0, std::nextafter(1.0, 2.0)}) {
    INFO("alpha = " << to_text(MassRatio(alpha)));
    CHECK(over_envelope(fast_values("angle", {alpha, 0}), oracle.at("angle", {alpha, 0})) <=
          allowed);
    constexpr std::int64_t two_51 = std::int64_t{1} << 51U;
    const auto counts = count_collisions(alpha);
    for (const std::int64_t n :
         {std::int64_t{0}, std::int64_t{1}, std::int64_t{2}, two_51 - 1, two_51, two_51 + 1,
          4 * two_51 - 1, 4 * two_51 + 1, 16 * two_51 + 3, 4095 * two_51 + 12345}) {
      if (n > (counts ? counts->N_A : std::numeric_limits<std::int64_t>::max())) continue;
      INFO("n = " << n);
      CHECK(over_envelope(fast_values("velocities", {alpha, n}),
                          oracle.at("velocities", {alpha, n})) <= allowed);
      if (counts && n >= counts->N_A + counts->N_B) continue;
      CHECK(over_envelope(fast_values("encounters", {alpha, n}),
                          oracle.at("encounters", {alpha, n})) <= allowed);
    }
  }
}

TEST_CASE("fast functions refuse what has no answer with one line", "[exam]") {
  const double nan = std::nan(""), infinity = HUGE_VAL;
  for (const double alpha : {0.0, -0.0, -1.0, nan, infinity, -infinity}) {
    CHECK_THROWS_AS(fast::velocities(alpha, 1), InvalidInput);
    CHECK_THROWS_AS(fast::velocities(alpha, 0), InvalidInput);
    CHECK_THROWS_AS(fast::encounters(alpha, 0), InvalidInput);
    CHECK_THROWS_AS(fast::encounters(alpha, 2), InvalidInput);
    CHECK_THROWS_AS(fast::terminal(alpha), InvalidInput);
    CHECK_THROWS_AS(fast::angle(alpha), InvalidInput);
  }
  CHECK_THROWS_WITH(fast::velocities(-0.1, 1), "alpha must be a positive finite number, got -0.1");
  CHECK_THROWS_WITH(fast::velocities(0.1, -1), "n must be 0 or more, got -1");
  CHECK_THROWS_WITH(fast::velocities(1.5, 2),
                    "n must be 0 or 1 from alpha = 1 on, where there are two collisions, got 2");
  CHECK_THROWS_WITH(fast::encounters(0.1, -1), "j must be 0 or more, got -1");
  CHECK_THROWS_WITH(fast::encounters(3.0, 2), "j must be below the number of collisions, 2, got 2");
  CHECK_THROWS_WITH(fast::ratios(0), "k must be 1 or more, got 0");
  CHECK_THROWS_AS(fast::encounters(1.0, 2), InvalidInput);
  for (const double x : {0.9, 0.1, 1e-3, 1e-7}) {
    const Counts counts = count_collisions(x).value();
    const std::int64_t total = counts.N_A + counts.N_B;
    for (std::int64_t j = total; j < 20 * total; j += 1 + total / 50)
      CHECK_THROWS_AS(fast::encounters(x, j), InvalidInput);
  }
}
