// SPDX-License-Identifier: GPL-2.0-or-later
// Doubles and exact rationals at the ends of the range, and errors between them. Ties and all
// doubles in between are in what the report measures.
#include "magicmass/oracle/rational.hpp"

#include <cmath>
#include <limits>

#include "catch.hpp"

using namespace magicmass::oracle;
using cln::cl_RA;
using Limits = std::numeric_limits<double>;

TEST_CASE("infinities, and what rounds to them", "[exam]") {
  CHECK_THROWS_AS(exact(Limits::infinity()), std::invalid_argument);
  CHECK_THROWS_AS(exact(Limits::quiet_NaN()), std::invalid_argument);
  const cl_RA tiny = exact(Limits::denorm_min());
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
