// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/statistics.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include <catch2/catch.hpp>

using namespace magicmass::report;

TEST_CASE("the median of fixed values", "[exam]") {
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 3, 2}) == 2.5);
  CHECK(median({7}) == 7);
  CHECK_THROWS_AS(median({}), std::invalid_argument);
}

TEST_CASE("ranks of the median's interval are those of printed tables", "[exam]") {
  // Conover, Practical Nonparametric Statistics: for 95 % the ranks from either end are 1 of 6, 2 of 10, 6 of 20,
  // 18 of 50, 19 of 51 and 40 of 100 values.
  const std::vector<std::pair<int, int>> ranks = {{6, 1},  {8, 1},   {9, 2},   {10, 2},
                                                  {20, 6}, {50, 18}, {51, 19}, {100, 40}};
  for (const auto& [size, rank] : ranks) {
    std::vector<double> values;
    for (int i = size; i >= 1; --i) values.push_back(i);
    const auto range = median_interval(values);
    REQUIRE(range);
    INFO(size);
    CHECK(range->low == rank);
    CHECK(range->high == size + 1 - rank);
  }
  CHECK_FALSE(median_interval({1, 2, 3, 4, 5}));
  CHECK_FALSE(median_interval({}));
}

TEST_CASE("the interval covers the true median as often as it says, for a skewed distribution",
          "[check]") {
  std::mt19937_64 generator(20);
  std::exponential_distribution<double> exponential(1.0);
  constexpr int trials = 4000;
  int covered = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> values(51);
    for (double& value : values) value = exponential(generator);
    const Range range = median_interval(values).value();
    covered += range.low <= std::log(2.0) && std::log(2.0) <= range.high ? 1 : 0;
  }
  // 96.5 % for ranks 19 and 33 of 51; five standard deviations of 4000 trials are 1.5 %.
  CHECK(covered > 0.95 * trials);
  CHECK(covered < 0.98 * trials);
}

TEST_CASE("a power law is found, with the spread of the textbook formula", "[exam]") {
  std::vector<Point> exact;
  for (const double x : {1.0, 2.0, 5.0, 100.0}) exact.push_back({x, 3 * std::pow(x, 1.5)});
  const auto law = fit_power_law(exact);
  REQUIRE(law);
  CHECK(law->exponent == Approx(1.5).margin(1e-12));
  CHECK(law->spread == Approx(0.0).margin(1e-12));
  // log x = 0, 1, 2 and log y = 0, 1, 0: slope 0, residuals -1/3, 2/3, -1/3, standard error sqrt((2/3)/1/2).
  const double e = std::exp(1.0);
  const std::vector<Point> bent = {{1, 1}, {e, e}, {e * e, 1}};
  const auto flat = fit_power_law(bent);
  REQUIRE(flat);
  CHECK(flat->exponent == Approx(0.0).margin(1e-12));
  CHECK(flat->spread == Approx(std::sqrt(1.0 / 3.0)));
}

TEST_CASE("points that have no logarithm do not count", "[exam]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Point> points = {{1, 1}, {2, 2}, {4, 4}, {8, 0}, {0, 8}, {16, infinity}};
  const auto law = fit_power_law(points);
  REQUIRE(law);
  CHECK(law->exponent == Approx(1.0));
  CHECK_FALSE(fit_power_law(std::span(points).first(2)));
  const std::vector<Point> upright = {{2, 1}, {2, 2}, {2, 3}};
  CHECK_FALSE(fit_power_law(upright));
}
