// SPDX-License-Identifier: GPL-2.0-or-later
// Doubles and exact rationals: both ways, at ties and at the ends of the range.
#include "magicmass/oracle/rational.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"

using namespace magicmass::oracle;
using cln::cl_I;
using cln::cl_RA;
using Limits = std::numeric_limits<double>;

TEST_CASE("every finite double comes back from its exact value", "[check]") {
  std::mt19937_64 random(1);
  int finite = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto x = std::bit_cast<double>(random());
    if (std::isfinite(x)) {
      ++finite;
      CHECK(nearest(exact(x)) == x);
    }
  }
  CHECK(finite > 2000);
  for (const double x : {0.0, Limits::denorm_min(), Limits::min(), Limits::max(), -1.5})
    CHECK(nearest(exact(x)) == x);
  CHECK_THROWS_AS(exact(Limits::infinity()), std::invalid_argument);
  CHECK_THROWS_AS(exact(Limits::quiet_NaN()), std::invalid_argument);
}

TEST_CASE("rounding is to nearest, ties to even", "[exam]") {
  const cl_RA ulp = exact(0x1p-52), tiny = exact(Limits::denorm_min());
  CHECK(nearest(1 + ulp / 2) == 1);
  CHECK(nearest(1 + 3 * ulp / 2) == 1 + 0x1p-51);
  CHECK(nearest(1 + ulp / 2 + tiny) == 1 + 0x1p-52);
  CHECK(nearest(1 - ulp / 4) == 1);
  CHECK(nearest(1 - ulp / 4 - tiny) == 1 - 0x1p-53);
  CHECK(nearest(tiny / 2) == 0);
  CHECK(nearest(tiny / 2 + tiny * tiny) == Limits::denorm_min());
  CHECK(nearest(-3 * tiny / 2) == -2 * Limits::denorm_min());
  const cl_RA overflow = exact(Limits::max()) + exact(0x1p970);
  CHECK(nearest(overflow) == Limits::infinity());
  CHECK(nearest(overflow - tiny) == Limits::max());
  CHECK(nearest(-overflow * overflow) == -Limits::infinity());
}

TEST_CASE("the ulp is the spacing in the exact value's binade", "[exam]") {
  CHECK(ulp_error(1, exact(1 - 0x1p-53)) == 1);
  CHECK(ulp_error(1, exact(1 + 0x1p-52)) == 1);
  CHECK(ulp_error(0.5, cl_RA(1) / 3) == nearest((cl_RA(1) / 6) / exact(0x1p-54)));
  CHECK(ulp_error(Limits::denorm_min(), 0) == 1);
  CHECK(ulp_error(Limits::max(), 2 * exact(0x1p1023)) == 1);
  CHECK(std::isinf(ulp_error(Limits::infinity(), 1)));
  CHECK(std::isinf(ulp_error(Limits::quiet_NaN(), 1)));
}
