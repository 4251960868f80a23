// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/enclosure.hpp"

#include <catch2/catch.hpp>

#include "magicmass/errors.hpp"

using namespace magicmass;
using namespace magicmass::reference;
using cln::cl_I;
using cln::cl_RA;

namespace {

const std::vector<long> precisions = {1, 10, 64, 500, 5000};

/// (x + 2)^2 encloses 5, for x = sec(pi/5) - 1 = sqrt(5) - 2; decided in rationals.
bool squares_to(const Interval& x, int shift, const cl_RA& square) {
  const cl_RA low = x.low() + shift;
  const cl_RA high = x.high() + shift;
  return low * low <= square && square <= high * high;
}

}  // namespace

TEST_CASE("ratios with square roots enclose them", "[exam]") {
  for (const long precision : precisions) {
    CHECK(squares_to(enclosure(MassRatio(Magic{2}))(precision), 2, 5));      // sqrt(5) - 2
    CHECK(squares_to(enclosure(MassRatio(Deficient{1}))(precision), 1, 2));  // sqrt(2) - 1
    CHECK(squares_to(enclosure(MassRatio(Deficient{2}))(precision), 1,
                     cl_RA(4) / 3));  // 2/sqrt(3) - 1
    CHECK_FALSE(squares_to(enclosure(MassRatio(Magic{2}))(64), 2, 5 + cl_RA(1) / (1L << 50)));
  }
}

TEST_CASE("enclosures are nested and no wider than promised", "[check]") {
  for (const MassRatio& alpha :
       {MassRatio(Magic{1}), MassRatio(Magic{7}), MassRatio(Deficient{1000000}), MassRatio(0.1),
        MassRatio(Fraction{"1", "7"}), MassRatio(1e-300)}) {
    const Enclosure source = enclosure(alpha);
    const Interval finest = source(10000);
    for (const long precision : precisions) {
      const Interval interval = source(precision);
      CHECK(interval.low() <= finest.low());
      CHECK(finest.high() <= interval.high());
      CHECK((interval.high() - interval.low()) * cln::ash(cl_I(1), precision) <= 4);
    }
  }
}

TEST_CASE("the first magic ratio is the number 1", "[exam]") {
  const Interval one = enclosure(MassRatio(Magic{1}))(100);
  CHECK(one.low() == 1);
  CHECK(one.high() == 1);
  CHECK_THROWS_AS(enclosure(MassRatio(Magic{0})), InvalidInput);
  CHECK_THROWS_AS(enclosure(MassRatio(Deficient{-1})), InvalidInput);
}
