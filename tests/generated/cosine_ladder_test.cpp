// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/cosine_ladder.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include <catch2/catch.hpp>

using namespace magicmass::generated;

namespace {

/// The ladder with the last sign of T_(2j+1) = 2 T_j T_(j+1) - x turned round.
CosinePair<double> wrong_ladder(unsigned m, double x) {
  CosinePair<double> pair{1.0, x};
  for (int bit = 31; bit >= 0; --bit) {
    const double between = 2 * pair.low * pair.high + x;
    pair = ((m >> static_cast<unsigned>(bit)) & 1U) == 0U
               ? CosinePair<double>{2 * pair.low * pair.low - 1, between}
               : CosinePair<double>{between, 2 * pair.high * pair.high - 1};
  }
  return pair;
}

/// cos(m h) and cos((m+1) h); in floating point the ladder's error is at most quadrupled a step.
bool agrees_with_cosine(const CosinePair<double>& pair, unsigned m, double h) {
  const double bound = 8.0 * (m + 1.0) * (m + 1.0) * std::numeric_limits<double>::epsilon();
  return std::fabs(pair.low - std::cos(m * h)) <= bound &&
         std::fabs(pair.high - std::cos((m + 1) * h)) <= bound;
}

}  // namespace

TEST_CASE("the ladder is exact over the integers", "[exam]") {
  // T_0..T_7 at 2: 1, 2, 7, 26, 97, 362, 1351, 5042
  const std::int64_t expected[] = {1, 2, 7, 26, 97, 362, 1351, 5042};
  for (unsigned m = 0; m < 7; ++m) {
    const auto pair = cosine_ladder<std::int64_t>(m, 2, 1);
    CHECK(pair.low == expected[m]);
    CHECK(pair.high == expected[m + 1]);
  }
}

TEST_CASE("the ladder takes m up to the last 64-bit number", "[exam]") {
  const auto pair = cosine_ladder(std::numeric_limits<std::uint64_t>::max(), 1.0, 1.0);  // h = 0
  CHECK(pair.low == 1.0);
  CHECK(pair.high == 1.0);
}

TEST_CASE("the ladder is a cosine, and a wrong sign in it would be noticed", "[check]") {
  for (const double h : {0.01, 0.3, 1.0}) {
    for (unsigned m = 0; m < 200; ++m) {
      REQUIRE(agrees_with_cosine(cosine_ladder(m, std::cos(h), 1.0), m, h));
      if (m >= 1) {
        REQUIRE_FALSE(agrees_with_cosine(wrong_ladder(m, std::cos(h)), m, h));
      }
    }
  }
}
