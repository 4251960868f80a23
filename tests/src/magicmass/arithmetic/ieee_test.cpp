// SPDX-License-Identifier: GPL-2.0-or-later
// The probe of the arithmetic sees a foreign rounding mode and flush to zero.
#include <cfenv>

#include "catch.hpp"
#include "magicmass/arithmetic/simd.hpp"

using magicmass::arithmetic::arithmetic_is_ieee;

TEST_CASE("the probe accepts rounding to nearest alone") {
  REQUIRE(arithmetic_is_ieee());
  for (int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const bool accepted = arithmetic_is_ieee();
    std::fesetround(FE_TONEAREST);
    CHECK_FALSE(accepted);
  }
  REQUIRE(arithmetic_is_ieee());
}
#if defined(__SSE2__)
TEST_CASE("the probe refuses flush to zero, and subnormals read as zero") {
  for (unsigned flag : {0x8000U, 0x0040U}) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before | flag);
    const bool accepted = arithmetic_is_ieee();
    _mm_setcsr(before);
    CHECK_FALSE(accepted);
  }
  REQUIRE(arithmetic_is_ieee());
}
#endif
