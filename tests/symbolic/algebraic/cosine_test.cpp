// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/cosine.hpp"

#include <catch2/catch.hpp>

#include "algebraic/cosine_polynomial.hpp"

using namespace magicmass::algebraic;
using cln::cl_I;
using cln::cl_RA;

namespace {

/// sin(n x)/sin(x) as a polynomial in 2 cos(x), by its recurrence: it changes sign at 2 cos(pi j/n), 0 < j < n.
Interval sine_ratio(const Interval& twice_cosine, long n, long precision) {
  Interval before(0, precision);
  Interval now(1, precision);
  for (long i = 1; i < n; ++i) {
    const Interval next = sum(product(twice_cosine, now, precision), -before, precision);
    before = now;
    now = next;
  }
  return now;
}

}  // namespace

// An oracle without pi and without trust in CLN's cosine: a sign change of a polynomial with integer coefficients.
TEST_CASE("both ends of a cosine lie on different sides of a root of its polynomial", "[exam]") {
  for (const long precision : {64L, 1000L, 5000L, 20000L})
    for (const long n : {5L, 7L, 8L, 30L, 97L})
      for (const long j : {1L, 2L, n / 3, n / 2 + 1, n - 1}) {
        const Interval c = cosine_of_turn(cl_RA(j) / (2 * n), precision);
        if (c.sign() == 0 || c.low().rational() == c.high().rational()) continue;
        INFO("cos(" << j << " pi/" << n << ") at " << precision);
        const long p = 2 * precision + 100;
        const Interval low = sine_ratio({2 * c.low().rational(), p}, n, p);
        const Interval high = sine_ratio({2 * c.high().rational(), p}, n, p);
        CHECK(low.sign() * high.sign() == -1);
        const cl_RA width = c.high().rational() - c.low().rational();
        CHECK(width * cln::ash(cl_I(1), precision - 1) <= cln::abs(c.high().rational()));
      }
}

TEST_CASE("cosines at different precisions overlap, and keep their symmetries", "[check]") {
  for (long i = 1; i < 200; ++i) {
    const cl_RA turn = cl_RA(i * 7919) / 1000003;
    const Interval low = cosine_of_turn(turn, 80);
    const Interval high = cosine_of_turn(turn, 800);
    CHECK(low.low().rational() <= high.low().rational());
    CHECK(low.high().rational() >= high.high().rational());
    for (const cl_RA& same : {-turn, turn + 1, 1 - turn})
      CHECK(cosine_of_turn(same, 80).low().rational() == low.low().rational());
    CHECK(sum(cosine_of_turn(turn + cl_RA(1) / 2, 80), low, 80).sign() == 2);
    // cos^2 + sin^2
    const Interval sine = cosine_of_turn(cl_RA(1) / 4 - turn, 80);
    const Interval one = sum(integer_power(low, 2, 80), integer_power(sine, 2, 80), 80);
    CHECK(one.low().rational() <= 1);
    CHECK(one.high().rational() >= 1);
  }
}

TEST_CASE("small angles keep their relative precision", "[exam]") {
  const cl_RA turn = cl_RA(1) / 4 - cl_RA(1) / cln::expt_pos(cl_I(10), cl_I(100));
  const Interval c = cosine_of_turn(turn, 64);  // sin(2 pi 10^-100)
  CHECK(c.sign() == 1);
  CHECK((c.high().rational() - c.low().rational()) * cln::ash(cl_I(1), 60) < c.low().rational());
}
