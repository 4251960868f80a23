// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/interval.hpp"

#include <random>

#include <catch2/catch.hpp>

#include "algebraic/budget.hpp"

using namespace magicmass::algebraic;
using cln::cl_I;
using cln::cl_RA;

namespace {

bool encloses(const Interval& interval, const cl_RA& x) {
  return interval.low().rational() <= x && x <= interval.high().rational();
}

/// Width at most 2^(slack - precision) of its size.
bool is_tight(const Interval& interval, long precision, long slack) {
  const cl_RA width = interval.high().rational() - interval.low().rational();
  return width * cln::expt(cl_RA(2), cl_I(precision - slack)) <=
         cln::abs(interval.low().rational()) + cln::abs(interval.high().rational());
}

class RandomRationals {
public:
  cl_RA operator()() {
    const auto number = [this](long low, long high) {
      return std::uniform_int_distribution<long>(low, high)(generator_);
    };
    const cl_RA x = cl_RA(number(-1000000, 1000000)) / cl_I(number(1, 1000000));
    return x * cln::expt(cl_RA(2), cl_I(number(-300, 300)));
  }

private:
  std::mt19937 generator_{3};
};

}  // namespace

TEST_CASE("operations on points enclose the exact result, tightly", "[check]") {
  RandomRationals random;
  for (int round = 0; round < 2000; ++round) {
    const long p = 20 + round % 200;
    const cl_RA x = random();
    const cl_RA y = random();
    const Interval a(x, p);
    const Interval b(y, p);
    CHECK(encloses(a, x));
    CHECK(encloses(sum(a, b, p), x + y));
    CHECK(encloses(product(a, b, p), x * y));
    CHECK(is_tight(product(a, b, p), p, 4));
    CHECK(encloses(integer_power(a, 5, p), cln::expt(x, 5)));
    CHECK(encloses(integer_power(a, 6, p), cln::expt(x, 6)));
    if (!cln::zerop(y)) {
      CHECK(encloses(quotient(a, b, p), x / y));
      CHECK(is_tight(quotient(a, b, p), p, 4));
    }
    for (const long n : {2L, 3L, 7L, 100L}) {
      const Interval r = real_root(Interval(cln::abs(x), p), n, p);
      CHECK(cln::expt(r.low().rational(), cl_I(n)) <= cln::abs(x));
      CHECK(cln::expt(r.high().rational(), cl_I(n)) >= cln::abs(x));
      CHECK(is_tight(r, p, 8));
    }
  }
}

TEST_CASE("operations on wide intervals enclose those on their members", "[check]") {
  RandomRationals random;
  const auto wide = [](const cl_RA& x, const cl_RA& y) {
    return Interval(x < y ? x : y, x < y ? y : x, 40);
  };
  for (int round = 0; round < 1000; ++round) {
    const cl_RA x[] = {random(), random()};
    const cl_RA y[] = {random(), random()};
    const Interval a = wide(x[0], x[1]);
    const Interval b = wide(y[0], y[1]);
    for (const cl_RA& u : {x[0], x[1], (x[0] + x[1]) / 2})
      for (const cl_RA& v : {y[0], y[1], (y[0] + y[1]) / 3 * 2}) {
        if (!encloses(b, v)) continue;
        CHECK(encloses(sum(a, b, 40), u + v));
        CHECK(encloses(product(a, b, 40), u * v));
        CHECK(encloses(integer_power(a, 2, 40), u * u));
        CHECK(encloses(integer_power(a, 3, 40), u * u * u));
        if (b.sign() == 2)
          CHECK_THROWS_AS(quotient(a, b, 40), Unbounded);
        else
          CHECK(encloses(quotient(a, b, 40), u / v));
      }
  }
}

TEST_CASE("ends of very different size are added without writing them out", "[exam]") {
  const Interval large = integer_power({2, 64}, cl_I(1) << 40, 64);
  const Interval total = sum(large, {cl_RA(1), 64}, 64);
  CHECK(total.sign() == 1);
  CHECK(total.top() - large.top() <= 1);
  CHECK(sum(total, -large, 64).sign() == 2);  // the 1 is lost, and that is seen
  CHECK_THROWS_AS(integer_power({2, 64}, cl_I(1) << 51, 64), BeyondBudget);
}

TEST_CASE("signs are those that are certain", "[exam]") {
  CHECK(Interval(0, 10).sign() == 0);
  CHECK(Interval(cl_RA(1) / 3, 10).sign() == 1);
  CHECK(Interval(-1, 0, 10).sign() == 2);
  CHECK(Interval(-2, -1, 10).sign() == -1);
  CHECK_THROWS_AS(real_root(Interval(-2, -1, 10), 2, 10), Unbounded);
  CHECK(real_root(Interval(-1, 4, 10), 2, 10).low().sign() == 0);
}
