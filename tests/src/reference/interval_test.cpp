// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/interval.hpp"

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"
#include "random_numbers.hpp"

using namespace magicmass;
using namespace magicmass::reference;
using cln::cl_RA;

namespace {

bool holds(const Interval& interval, const cl_RA& x) {
  return interval.low() <= x && x <= interval.high();
}

cl_RA random_rational(testing::Generator& generator) {
  return cl_RA(testing::whole(generator, -1000, 1000)) / testing::whole(generator, 1, 1000);
}

}  // namespace

TEST_CASE("an interval is as tight as its precision allows", "[exam]") {
  const Interval third(cl_RA(1) / 3, 4);  // 5/16 < 1/3 < 6/16
  CHECK(third.low() == cl_RA(5) / 16);
  CHECK(third.high() == cl_RA(6) / 16);
  const Interval minus_third(cl_RA(-1) / 3, 4);
  CHECK(minus_third.low() == cl_RA(-6) / 16);
  CHECK(minus_third.high() == cl_RA(-5) / 16);
  const Interval half(cl_RA(1) / 2, 4);
  CHECK(half.low() == half.high());
  CHECK((Interval(1) / (Interval(1) + Interval(cl_RA(1), 4))).low() == cl_RA(1) / 2);
}

TEST_CASE("signs are certain or open", "[exam]") {
  CHECK(Interval(cl_RA(1) / 3, 4).sign() == Sign::positive);
  CHECK(Interval(cl_RA(-1) / 3, 4).sign() == Sign::negative);
  CHECK(Interval(cl_RA(1) / 3, 1).sign() == Sign::open);  // [0, 1/2]
  CHECK(Interval(0).sign() == Sign::zero);
  CHECK((Interval(cl_RA(1) / 4, 4) - Interval(cl_RA(1) / 4, 4)).sign() == Sign::zero);
  CHECK((Interval(cl_RA(1) / 3, 4) - Interval(cl_RA(1) / 3, 4)).sign() == Sign::open);
}

TEST_CASE("division by what may be zero is refused", "[exam]") {
  CHECK_THROWS_AS(Interval(1) / Interval(0), Undecided);
  CHECK_THROWS_AS(Interval(1) / Interval(cl_RA(1) / 100, 4), Undecided);
}

TEST_CASE("every operation holds the exact result, for all signs and mixed precisions", "[check]") {
  testing::Generator generator(15);
  for (int i = 0; i < 20000; ++i) {
    const cl_RA x_low = random_rational(generator);
    const cl_RA x_high =
        x_low + cln::abs(random_rational(generator)) / testing::whole(generator, 1, 1000);
    const cl_RA y_low = random_rational(generator);
    const cl_RA y_high =
        y_low + cln::abs(random_rational(generator)) / testing::whole(generator, 1, 1000);
    const Interval x(x_low, x_high, testing::whole(generator, 0, 40));
    const Interval y(y_low, y_high, testing::whole(generator, 0, 40));
    for (const cl_RA& u : {x_low, (x_low + x_high) / 2, x_high}) {
      for (const cl_RA& v : {y_low, (y_low + 2 * y_high) / 3, y_high}) {
        REQUIRE(holds(x + y, u + v));
        REQUIRE(holds(x - y, u - v));
        REQUIRE(holds(x * y, u * v));
        if (y.sign() == Sign::positive || y.sign() == Sign::negative) {
          REQUIRE(holds(x / y, u / v));
        }
      }
    }
  }
}

TEST_CASE("operations lose no more than a unit of the last place", "[check]") {
  testing::Generator generator(16);
  const cl_RA unit = cl_RA(1) / (1L << 40);
  for (int i = 0; i < 5000;
       ++i) {  // dyadic ends, so that all width comes from the operation itself
    const Interval x(cl_RA(testing::whole(generator, -(1L << 20), 1L << 20)) / (1L << 20), 40);
    const Interval y(cl_RA(testing::whole(generator, 1, 1L << 20)) / (1L << 20), 40);
    REQUIRE((x + y).low() == (x + y).high());
    REQUIRE((x * y).low() == (x * y).high());
    REQUIRE((x / y).high() - (x / y).low() <= unit);
    REQUIRE((x / (Interval(0) - y)).high() - (x / (Interval(0) - y)).low() <= unit);
  }
}
