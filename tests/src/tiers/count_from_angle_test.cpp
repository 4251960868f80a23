// SPDX-License-Identifier: GPL-2.0-or-later
// Counts from an angle: right just outside of the margin, undecided within it.
#include "magicmass/tiers/count_from_angle.hpp"

#include <cmath>

#include <catch2/catch.hpp>

#include "magicmass/tiers/clear_count.hpp"

using namespace magicmass;
using magicmass::arithmetic::Pair;

namespace {

/// pi/(2 k) (1 + excess), to 2^-100 or so.
Pair<double> half_angle_at(double k, double excess) {
  const Pair<double> exactly =
      Pair<double>(arithmetic::half_pi[0], arithmetic::half_pi[1]) / Pair<double>(k);
  return normalised(exactly + exactly * excess);
}

}  // namespace

TEST_CASE("an angle tells the count up to its error, and not beyond", "[exam]") {
  for (const double k : {3.0, 4.0, 7.0, 1000.0, 0x1p20 + 1, 0x1p32, 0x1p40 - 1, 0x1p52 + 3}) {
    INFO(k);
    const auto whole = static_cast<std::int64_t>(k);
    for (const double excess : {0x1p-4, 0x1p-40, 0x1p-60, 0x1p-90}) {
      if (k * excess > 0.5) continue;
      INFO(excess);
      // a greater angle has fewer collisions: ceil(pi/h) - 1
      CHECK(tiers::total_from_angle(half_angle_at(k, excess), excess / 4) == whole - 1);
      CHECK(tiers::total_from_angle(half_angle_at(k, -excess), excess / 4) == whole);
      CHECK(tiers::total_from_angle(half_angle_at(k, excess), excess * 4) == 0);
      CHECK(tiers::total_from_angle(half_angle_at(k, -excess), excess * 4) == 0);
    }
    CHECK(tiers::total_from_angle(half_angle_at(k, 0.0), 0.0) == 0);
  }
  CHECK(tiers::total_from_angle(Pair<double>(0x1p-63), 0x1p-60) == 0);  // beyond 2^63
}

TEST_CASE("a clear count leaves a margin next to each threshold", "[exam]") {
  for (const double k : {4.0, 5.0, 17.0, 1000.0}) {
    INFO(k);
    const double alpha = 1 / std::cos(std::acos(-1.0) / k) - 1;  // oracle: N_A + N_B changes here
    const auto whole = static_cast<std::int64_t>(k);
    CHECK(tiers::clear_total(alpha * (1 + 0x1p-10)) == whole - 1);
    CHECK(tiers::clear_total(alpha * (1 - 0x1p-10)) == whole);
    for (const double excess : {0.0, 0x1p-52, -0x1p-52, 0x1p-24, -0x1p-24})
      CHECK(tiers::clear_total(alpha * (1 + excess)) == 0);
  }
  CHECK(tiers::clear_total(0x1p-24) == 0);  // too many for single precision
}
