// SPDX-License-Identifier: GPL-2.0-or-later
// Lanes of every width do what a double does, special values included.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

#include "arithmetic/every_width.hpp"
#include "magicmass/reference/rational.hpp"

using namespace magicmass;
using namespace magicmass::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Each special value with each.
Columns special_pairs() {
  const double values[] = {0.0,      -0.0,      1.0, -1.0,     5e-324, -5e-324, 0x1p-1022, 1e308,
                           infinity, -infinity, 2.5, 0x1p1023, -2.5,   0x1p52,  0x1p-60,   3.0};
  Columns pairs(2);
  for (const double x : values)
    for (const double y : values) {
      pairs[0].push_back(x);
      pairs[1].push_back(y);
    }
  return pairs;
}

Columns random_columns(std::uint64_t seed, std::size_t columns, std::size_t rows, int low,
                       int high) {
  Generator generator(seed);
  Columns all(columns);
  for (auto& column : all)
    for (std::size_t i = 0; i < rows; ++i) column.push_back(any_double(generator, low, high));
  return all;
}

double number(bool condition) { return condition ? 1.0 : 0.0; }

}  // namespace

TEST_CASE("sums, products, quotients and roots of lanes are those of doubles", "[exam]") {
  for (const Columns& in : {special_pairs(), random_columns(1, 2, 999, -1000, 1000)}) {
    const auto out = the_same_at_every_width("operations", in, true);
    for (std::size_t i = 0; i < in[0].size(); ++i) {
      const double x = in[0][i], y = in[1][i];
      const auto alike = [](double a, double b) {
        return a == b ? std::signbit(a) == std::signbit(b) : std::isnan(a) && std::isnan(b);
      };
      INFO(x << ", " << y);
      REQUIRE(alike(out[0][i], x + y));
      REQUIRE(alike(out[1][i], x - y));
      REQUIRE(alike(out[2][i], x * y));
      REQUIRE(alike(out[3][i], x / y));
      REQUIRE(alike(out[4][i], -x));
      REQUIRE(alike(out[5][i], std::fabs(x)));
      REQUIRE(alike(out[6][i], std::sqrt(std::fabs(x))));
    }
  }
}

TEST_CASE("comparisons and choices of lanes are those of doubles, NaN included", "[exam]") {
  Columns in = special_pairs();
  for (const double x : {std::nan(""), 1.0, -infinity}) {
    in[0].push_back(x);
    in[1].push_back(std::nan(""));
  }
  const auto out = the_same_at_every_width("comparisons", in, true);
  Columns choices{in[0], in[1], in[1], in[0]};
  const auto chosen = the_same_at_every_width("choices", choices, true);
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const double x = in[0][i], y = in[1][i];
    INFO(x << ", " << y);
    REQUIRE(out[0][i] == number(x < y));
    REQUIRE(out[1][i] == number(x > y));
    REQUIRE(out[2][i] == number(x <= y));
    REQUIRE(out[3][i] == number(x >= y));
    REQUIRE(out[4][i] == number(x == y));
    REQUIRE(same_bits({chosen[0][i]}, {x < y ? y : x}));
    REQUIRE(same_bits({chosen[1][i]}, {x < y ? y : 0.0}));
    REQUIRE(same_bits({chosen[2][i]}, {y < x ? y : x}));
    REQUIRE(same_bits({chosen[3][i]}, {std::signbit(x) ? -y : y}));
  }
}

TEST_CASE("whole numbers, tables and polynomials", "[exam]") {
  const Columns halves{{0.5, 1.5, 2.5, -0.5, -1.5, 0.49999999999999994, 0x1p51 - 0.5, 7.0, -3.2}};
  CHECK(the_same_at_every_width("nearest_whole", halves, true)[0] ==
        std::vector{0.0, 2.0, 2.0, -0.0, -2.0, 0.0, 0x1p51, 7.0, -3.0});
  // next to multiples of 2^-8, and where it is a tie
  const Columns near{{0.0, 0x1.03p-6, 0x1.7ffp-9, 0x1.4p-7, 0x1.0001p-7}};
  const auto columns = the_same_at_every_width("table_columns", near, true);
  CHECK(columns[6] == std::vector{0.0, 0x1p-6, 0x1p-8, 0x1p-7, 0x1p-7});
  CHECK(columns[0] == std::vector{0.0, 16.0, 4.0, 8.0, 8.0});
  CHECK(columns[1] == std::vector{1.0, 17.0, 5.0, 9.0, 9.0});
  CHECK(columns[2] == std::vector{2.0, 18.0, 6.0, 10.0, 10.0});
  CHECK(columns[3] == std::vector{3.0, 19.0, 7.0, 11.0, 11.0});
  CHECK(columns[4] == std::vector{0.0, 8.0, 2.0, 4.0, 4.0});
  CHECK(columns[5] == std::vector{1.0, 9.0, 3.0, 5.0, 5.0});
  // Estrin's: each coefficient at its power
  const auto values = the_same_at_every_width("polynomial", {{0.0, 1.0, -1.0, 2.0, 0.25}})[0];
  const auto expected = [](double z) {
    return 0.3 + z * (-0.7 + z * (0x1.1p-3 + z * (5.0 + z * (-0.01 + z * (0x1.fp1 - z)))));
  };
  for (std::size_t i = 0; i < 5; ++i) {
    const double z[] = {0.0, 1.0, -1.0, 2.0, 0.25};
    CHECK(std::fabs(values[i] - expected(z[i])) < 1e-12);
  }
}

TEST_CASE("estimates are within 2^-22.5 from 2^-126 to 2^126", "[check]") {
  Columns in = random_columns(2, 1, 4000, -126, 125);
  for (double& x : in[0]) x = std::fabs(x);
  in[0].insert(in[0].end(), {0x1p-126, 0x1p126, 1.0, 0x1.fffffffffffffp-1, 0x1.0000000000001p0});
  const auto out = the_same_at_every_width("estimates", in, true);
  const cln::cl_RA allowed = reference::exact(std::exp2(-22.5));
  double worst = 0.0;
  for (std::size_t i = 0; i < in[0].size(); ++i) {
    const cln::cl_RA x = reference::exact(in[0][i]), root = reference::exact(out[1][i]);
    INFO(in[0][i]);
    const cln::cl_RA of_reciprocal = cln::abs(reference::exact(out[0][i]) * x - 1);
    REQUIRE(of_reciprocal <= allowed);
    // (1 + e)^2 - 1 is 2 e but for e^2
    REQUIRE(cln::abs(root * root * x - 1) <= allowed * 2);
    worst = std::max(worst, cln::double_approx(of_reciprocal));
  }
  CHECK(worst > 0x1p-24);  // the measure sees an error
}
