// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/exact_value.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <cln/integer.h>

#include "magicmass/reference/rational.hpp"

using namespace magicmass;
using namespace magicmass::report;

namespace {
const cln::cl_RA third = cln::cl_RA(1) / 3;
const cln::cl_RA tiny_part = cln::cl_RA(1) / cln::cl_RA(cln::ash(cln::cl_I(1), 100));
}  // namespace

TEST_CASE("an exact value keeps 120 bits and its nearest numbers", "[exam]") {
  const ExactValue value = exact_value(third);
  const cln::cl_RA kept = reference::exact(value.high) + reference::exact(value.low);
  CHECK(cln::abs(kept - third) * cln::cl_RA(cln::ash(cln::cl_I(1), 120)) < third);
  CHECK(value.nearest_double == 1.0 / 3.0);
  CHECK(value.nearest_float == 1.0F / 3.0F);
  CHECK(value.binade == -2);
}

TEST_CASE("the binade is the value's own where its nearest number is a power of two", "[exam]") {
  CHECK(exact_value(1 - tiny_part).binade == -1);
  CHECK(exact_value(1 + tiny_part).binade == 0);
  CHECK(exact_value(1).binade == 0);
  CHECK(exact_value(tiny_part - 1).binade == -1);
}

TEMPLATE_TEST_CASE("deviations agree with the reference's exact ulp errors", "[exam]", float,
                   double, long double) {
  const auto right = static_cast<TestType>(1) / static_cast<TestType>(3);
  TestType got = right;
  for (int step = 0; step < 4; ++step) {
    const Deviation found = deviation(got, exact_value(third));
    CHECK(found.ulp == Approx(reference::ulp_error(got, third)).epsilon(1e-12));
    CHECK(found.correctly_rounded == (step == 0));
    CHECK(found.over_envelope == found.ulp / 0.5);
    CHECK_FALSE(found.wrong_sign);
    got = std::nextafter(got, static_cast<TestType>(1));
  }
  const Deviation opposite = deviation(-right, exact_value(third));
  CHECK(opposite.wrong_sign);
  CHECK(opposite.eps > 1e6);
}

TEST_CASE("the envelope is what rounding alpha costs", "[exam]") {
  ExactValue value = exact_value(third);
  value.condition = 100;
  const Deviation found = deviation(1.0 / 3.0 + 10 * 0x1p-54, value);
  CHECK(found.over_envelope == Approx(found.ulp / 50));
}

TEST_CASE("an exact zero has no ulp, and anything else there has a wrong sign", "[exam]") {
  ExactValue zero = exact_value(0);
  zero.scale = 1;
  CHECK(deviation(0.0, zero).correctly_rounded);
  CHECK(deviation(-0.0, zero).correctly_rounded);
  const Deviation off = deviation(0x1p-52, zero);
  CHECK_FALSE(off.has_ulp);
  CHECK(off.ulp == 0);
  CHECK(off.wrong_sign);
  CHECK(off.eps == 1);
}

TEST_CASE("no number and no finite number are as wrong as can be", "[exam]") {
  for (const double got : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL}) {
    const Deviation found = deviation(got, exact_value(third));
    CHECK(std::isinf(found.ulp));
    CHECK(std::isinf(found.eps));
    CHECK_FALSE(found.correctly_rounded);
  }
  CHECK(deviation(std::nan(""), exact_value(third)).wrong_sign);
}

TEST_CASE("a rounding that is open is seen to be", "[exam]") {
  const cln::cl_RA tie = 1 + cln::cl_RA(1) / cln::cl_RA(cln::ash(cln::cl_I(1), 53));
  CHECK(rounding_is_certain(third, 200));
  CHECK_FALSE(rounding_is_certain(third, 10));
  CHECK_FALSE(rounding_is_certain(tie, 500));
}
