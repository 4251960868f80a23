// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/simulator/rounding_margin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <catch2/catch.hpp>

using namespace magicmass;

namespace {

/// How far velocities of masses m1 and m2 differ at most, whose length sqrt(m1 v1^2 + m2 v2^2) is 1.
double largest_difference(double m1, double m2) {
  double largest = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double turn = 1.5707963267948966 * i / 10000;
    largest = std::max(largest, std::cos(turn) / std::sqrt(m1) + std::sin(turn) / std::sqrt(m2));
  }
  return largest;
}

}  // namespace

TEST_CASE("a gap closes certainly from the speed on that errors of its two sides can make up",
          "[exam]") {
  Line<double> line{
      {1e-6, 1.0, 3.0}, {0.0, 1.0, 2.0}, {1.0, 0.5, -1.0}, std::nullopt, std::nullopt};
  line.is_rounded = true;
  const RoundingMargin<double> margin(line);
  for (const auto& [m1, m2] : {std::pair{1.0, 3.0}, std::pair{3.0, 1.0}, std::pair{2.0, 2.0}}) {
    INFO(m1 << " and " << m2);
    const double most = margin.of_velocities() * largest_difference(m1, m2);
    CHECK(margin.reaches_closing({m1, 0.999 * most, m2, 0.0}));
    CHECK(margin.reaches_closing({m1, 0.0, m2, 0.999 * most}));
    CHECK_FALSE(margin.reaches_closing({m1, 1.001 * most, m2, 0.0}));
    CHECK_FALSE(margin.reaches_closing({m1, 0.0, m2, 1.001 * most}));
  }
}

TEST_CASE("a wall takes no part in the difference, and what is not rounded has no margin",
          "[exam]") {
  Line<double> line{{1e-6, 4.0}, {0.0, 1.0}, {1.0, 0.5}, std::nullopt, std::nullopt};
  const double infinity = HUGE_VAL;
  CHECK_FALSE(RoundingMargin<double>(line).reaches_closing({4.0, 0.0, infinity, 0.0}));
  line.is_rounded = true;
  const RoundingMargin<double> margin(line);
  CHECK(margin.reaches_closing({4.0, 0.499 * margin.of_velocities(), infinity, 0.0}));
  CHECK_FALSE(margin.reaches_closing({4.0, 0.501 * margin.of_velocities(), infinity, 0.0}));
}
