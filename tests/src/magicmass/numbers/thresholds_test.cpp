// SPDX-License-Identifier: GPL-2.0-or-later
// Ratios, the angle and the nearest threshold.
#include "src/magicmass/numbers/checks.hpp"

using namespace magicmass;
using namespace magicmass::testing;

namespace {
/// (x - alpha)/alpha.
struct Distance {
  cln::cl_RA x;
  cln::cl_I j = 0;
  std::vector<cln::cl_RA> operator()(const cln::cl_RA& alpha) const {
    return {(x - alpha) / alpha};
  }
  std::vector<oracle::Interval> operator()(const oracle::Interval& alpha) const {
    return {(oracle::Interval(x, alpha.precision()) - alpha) / alpha};
  }
};
oracle::MassRatio threshold(bool is_magic, std::int64_t k) {
  return is_magic ? oracle::magic(whole(k)) : oracle::deficient(whole(k));
}
double distance_by_oracle(double alpha, bool is_magic, std::int64_t k) {
  return oracle::certain(threshold(is_magic, k), Distance{oracle::exact(alpha)},
                         oracle::to_double())[0];
}
}  // namespace

TEST_CASE("ratios are rounded right") {
  Random random(31);
  CHECK(accurate::ratios(1).magic == 1);
  for (int row = 0; row < 150; ++row)
    check_ratios(row < 20 ? row + 1 : some_whole(random, row % 2 == 0 ? 1e6 : 0x1p62));
  for (const std::int64_t k : {(std::int64_t{1} << 50) + 1, INT64_MAX}) check_ratios(k);
}
TEST_CASE("the angle is rounded right for every alpha") {
  Random random(32);
  for_families(random, 12, check_angle);
}
TEST_CASE("the nearest threshold and its distance") {
  Random random(33);
  for_families(random, 8, [&](double alpha) {
    const std::optional<Threshold> t = nearest_threshold(alpha);
    REQUIRE(t.has_value() == counts_by_oracle(alpha).has_value());
    if (!t) return;
    REQUIRE(t->distance == distance_by_oracle(alpha, t->is_magic, t->k));
    // alpha_k > beta_k > alpha_(k+1): neither neighbour is nearer.
    const double above =
        t->is_magic && t->k == 1
            ? 1e300
            : distance_by_oracle(alpha, !t->is_magic, t->is_magic ? t->k - 1 : t->k);
    const double below = distance_by_oracle(alpha, !t->is_magic, t->is_magic ? t->k : t->k + 1);
    CHECK(std::fabs(above) >= std::fabs(t->distance));
    CHECK(std::fabs(below) >= std::fabs(t->distance));
  });
  CHECK(nearest_threshold(0x1.1c7397cb68b7ep-18)->k == 539);
  CHECK(nearest_threshold(0x1.bc7fb47556f22p-29)->k == 19530);
  CHECK_FALSE(nearest_threshold(0x1.bc7fb47556f22p-29)->is_magic);
  CHECK(nearest_threshold(1)->distance == 0);
}
