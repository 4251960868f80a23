// Doubles and exact rationals at the ends of the range, and errors between them; ties and all
// doubles in between are in what the report measures. Intervals hold the result, and hardly more.
#include <cmath>
#include <limits>
#include <random>

#include "catch.hpp"
#include "magicmass/oracle/interval.hpp"
#include "magicmass/oracle/rational.hpp"

using namespace magicmass::oracle;
using Limits = std::numeric_limits<double>;

namespace {

bool holds(const Interval& interval, const cl_RA& x) {
  return interval.low() <= x && x <= interval.high();
}

/// Within 2^(bits - p) at each end.
bool is_tight(const Interval& interval, const cl_RA& x, long bits) {
  const cl_RA step = cl_RA(cln::ash(cl_I(1), bits)) / cln::ash(cl_I(1), interval.precision());
  return x - interval.low() <= step && interval.high() - x <= step;
}

}  // namespace

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

TEST_CASE("an operation encloses the exact result", "[check]") {
  std::mt19937_64 random(2);
  const auto draw = [&] {
    const auto above = static_cast<long>(random() % 2001) - 1000;
    return cl_RA(above) / static_cast<long>(1 + random() % 97);
  };
  for (int i = 0; i < 500; ++i) {
    const cl_RA x = draw(), y = draw();
    const Interval u(x, 40), v(y, 60);
    CHECK((holds(u + v, x + y) && is_tight(u + v, x + y, 21)));
    CHECK((holds(u - v, x - y) && is_tight(u - v, x - y, 21)));
    CHECK((holds(u * v, x * y) && is_tight(u * v, x * y, 31)));
    if (v.sign() == Sign::positive || v.sign() == Sign::negative) CHECK(holds(u / v, x / y));
    const Interval wide(cln::min(x, y), cln::max(x, y), 10);
    const cl_RA z = draw(), w = draw();
    const Interval other(cln::min(z, w), cln::max(z, w), 12);
    for (const cl_RA& corner : {x, y}) {
      CHECK((holds(wide * other, corner * z) && holds(wide * other, corner * w)));
      CHECK((holds(wide - other, corner - z) && holds(wide - other, corner - w)));
    }
  }
}

TEST_CASE("signs are certain or open", "[exam]") {
  const cl_RA third = cl_RA(1) / 3;
  CHECK(Interval(third, 8).sign() == Sign::positive);
  CHECK(Interval(third / 1000, 8).sign() == Sign::open);
  CHECK(Interval(-third, 8).sign() == Sign::negative);
  CHECK(Interval(0).sign() == Sign::zero);
  CHECK_THROWS_AS(Interval(1) / Interval(0), Undecided);
  CHECK_THROWS_AS(Interval(1) / Interval(third / 1000, 8), Undecided);
  CHECK(holds(Interval(1) / Interval(-third, 8), -3));
}
