// SPDX-License-Identifier: GPL-2.0-or-later
// The probe of the arithmetic sees a foreign rounding mode and flush to zero.
#include "catch.hpp"
#include "src/magicmass/arithmetic/foreign_modes.hpp"

using namespace magicmass;

TEST_CASE("the probe accepts rounding to nearest and subnormals alone") {
  CHECK(arithmetic::arithmetic_is_ieee());
  const auto refuses = [] { return !arithmetic::arithmetic_is_ieee(); };
  CHECK(testing::in_foreign_modes(refuses));
  CHECK(arithmetic::arithmetic_is_ieee());
}
