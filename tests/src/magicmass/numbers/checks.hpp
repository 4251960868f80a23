// SPDX-License-Identifier: GPL-2.0-or-later
// Single numbers of both tiers against the oracle, for tests that differ in their inputs.
#pragma once

#include "catch.hpp"
#include "magicmass/numbers/fast.hpp"
#include "src/magicmass/numbers/by_oracle.hpp"
#include "src/magicmass/numbers/families.hpp"

namespace magicmass::testing {
/// So many mass ratios of each family.
void for_families(Random& random, int rows, const auto& check) {
  for (const Family& family : families) {
    for (int row = 0; row < rows; ++row) {
      const double alpha = family.alpha(random);
      INFO(family.name << ", alpha = " << in_hex(alpha));
      check(alpha);
    }
  }
}
inline void check_collision(double alpha, std::int64_t j) {
  INFO("alpha = " << in_hex(alpha) << ", j = " << j);
  REQUIRE(accurate::collision(alpha, j) == collision_by_oracle(alpha, j));
  CHECK(envelopes_of(fast::collision(alpha, j), alpha, j) <= 4);
}
inline void check_ratios(std::int64_t k) {
  INFO("k = " << k);
  const Ratios exact = ratios_by_oracle(k), near = fast::ratios(k);
  REQUIRE(accurate::ratios(k) == exact);
  CHECK_THAT(near.magic, WithinULP(exact.magic, 1));
  CHECK_THAT(near.deficient, WithinULP(exact.deficient, 1));
}
inline void check_angle(double alpha) {
  const double exact = angle_by_oracle(alpha);
  REQUIRE(accurate::angle(alpha) == exact);
  CHECK_THAT(fast::angle(alpha), WithinULP(exact, 1));
}
}  // namespace magicmass::testing
