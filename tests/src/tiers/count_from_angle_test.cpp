// SPDX-License-Identifier: GPL-2.0-or-later
// Counts from an angle: right just outside of the margin, undecided within it.
#include "magicmass/tiers/count_from_angle.hpp"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

#include "magicmass/tiers/clear_count.hpp"

using namespace magicmass;
using namespace magicmass::tiers;
using magicmass::arithmetic::Pair;

namespace {

/// pi/(2 k) (1 + excess), to 2^-100 or so.
Pair<double> half_angle_at(double k, double excess) {
  const Pair<double> exactly = scaled(Pair<double>::pi(), 0.5) / Pair<double>(k);
  return normalised(exactly + exactly * excess);
}

}  // namespace

TEST_CASE("an angle tells the count up to its error, and not beyond", "[exam]") {
  for (const double k :
       {3.0, 4.0, 7.0, 1000.0, 0x1p20 + 1, 0x1p32, 0x1p40 - 1, 0x1p52 + 3, 0x1p55 + 24, 0x1.8p62}) {
    INFO(k);
    const auto whole = static_cast<std::int64_t>(k);
    const double known = k < 0x1p20 ? 0x1p-21 : 0x1p-48;
    for (const double excess : {0x1p-23, 0x1p-40, 0x1p-60, 0x1p-90}) {
      if (k * excess > 0x1p-2) continue;
      INFO(excess);
      for (const double off : {-0.9, 0.0, 0.9}) {
        const TurnsToPi turns{k * (1.0 + off * known), known};
        INFO(off);
        // a greater angle has fewer collisions: ceil(pi/h) - 1
        CHECK(total_from_angle(turns, half_angle_at(k, excess), excess / 4) == whole - 1);
        CHECK(total_from_angle(turns, half_angle_at(k, -excess), excess / 4) == whole);
        CHECK(total_from_angle(turns, half_angle_at(k, excess), excess * 4) == 0);
        CHECK(total_from_angle(turns, half_angle_at(k, -excess), excess * 4) == 0);
      }
    }
    CHECK(total_from_angle({k, known}, half_angle_at(k, 0.0), 0.0) == 0);
  }
  // too many
  CHECK(total_from_angle({0x1p63, 0x1p-48}, half_angle_at(0x1p63, 0x1p-66), 0x1p-70) == 0);
  CHECK(total_from_angle({0x1p63 - 1024, 0x1p-48}, half_angle_at(0x1p63, -0x1p-66), 0x1p-70) == 0);
}

TEST_CASE("a clear count leaves a margin next to each threshold", "[exam]") {
  const auto total_of = [](double alpha) { return clear_total(turns_to_pi(alpha)); };
  for (const double k : {4.0, 5.0, 17.0, 1000.0}) {
    INFO(k);
    const double alpha = 1 / std::cos(std::acos(-1.0) / k) - 1;  // oracle: N_A + N_B changes here
    const auto whole = static_cast<std::int64_t>(k);
    CHECK(total_of(alpha * (1 + 0x1p-10)) == whole - 1);
    CHECK(total_of(alpha * (1 - 0x1p-10)) == whole);
    // of alpha, which pi/h takes half of
    const double margin = turns_to_pi(alpha).relative_error;
    for (const double excess : {0.0, 0x1p-52, -0x1p-52, margin, -margin})
      CHECK(total_of(alpha * (1 + excess)) == 0);
  }
}

TEST_CASE("pi/h is known within what it says, and not far from it", "[check]") {
  double worst[2] = {
      0.0,
      0.0};  // of the error in parts of what it may be: where the slope leaves most, and where rounding does
  for (int e = -120; e < 0; ++e)
    for (double alpha = std::ldexp(1.0, e); alpha < std::ldexp(2.0, e); alpha *= 1.007) {
      INFO(alpha);
      const long double x = alpha;  // the oracle has 11 digits more
      const long double exactly = std::acos(-1.0L) / (2 * std::atan(std::sqrt(x / (2 + x))));
      const TurnsToPi turns = turns_to_pi(alpha);
      const auto off =
          static_cast<double>(std::fabs(turns.quotient / exactly - 1) / turns.relative_error);
      REQUIRE(off < 0.5);
      double& most = worst[e < -30 ? 1 : 0];
      most = std::max(most, off);
    }
  CHECK(worst[0] > 0x1p-6);
  CHECK(worst[1] > 0x1p-6);
}
