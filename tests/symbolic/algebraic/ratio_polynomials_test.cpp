// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/ratio_polynomials.hpp"

#include <numeric>

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "algebraic/cosine.hpp"
#include "algebraic/cosine_polynomial.hpp"
#include "algebraic/polynomial_value.hpp"
#include "magicmass/errors.hpp"

using namespace magicmass::algebraic;
using cln::cl_I;
using cln::cl_RA;

namespace {

long totient(long m) {
  long count = 0;
  for (long j = 1; j <= m; ++j) count += std::gcd(j, m) == 1 ? 1 : 0;
  return count;
}

/// sec(pi/n) - 1 from intervals, not from the polynomial.
Interval ratio(long n, long precision) {
  return sum(quotient({1, precision}, cosine_of_turn(cl_RA(1) / (2 * n), precision), precision),
             {-1, precision}, precision);
}

void check_polynomial(const Polynomial& p, long n) {
  INFO("sec(pi/" << n << ") - 1: " << to_text(p));
  CHECK(p.degree() == totient(2 * n) / 2);
  CHECK(primitive(p) == p);
  // It vanishes to 200 digits, and its root is where the ratio is: a sign change around it.
  const long precision = 800 + 12 * p.degree();
  const Interval x = ratio(n, precision);
  const Interval at_ratio = value(p, x, precision);
  CHECK(at_ratio.sign() != 1);
  CHECK(at_ratio.sign() != -1);
  CHECK((at_ratio.sign() == 0 || at_ratio.top() < -665));
  const Interval off(cln::expt(cl_RA(10), -190), precision);
  if (n > 3)
    CHECK(value(p, sum(x, off, precision), precision).sign() *
              value(p, sum(x, -off, precision), precision).sign() ==
          -1);
}

GiNaC::ex expression(const Polynomial& p, const GiNaC::symbol& x) {
  GiNaC::ex result = 0;
  for (std::size_t i = 0; i < p.coefficients.size(); ++i)
    result += GiNaC::numeric(p.coefficients[i]) * GiNaC::pow(x, static_cast<int>(i));
  return result;
}

}  // namespace

TEST_CASE("the polynomials of all ratios to 200 vanish there and have the right degree", "[exam]") {
  for (long k = 1; k <= 200; ++k) {
    check_polynomial(magic_polynomial(k), 2 * k + 1);
    check_polynomial(deficient_polynomial(k), 2 * (k + 1));
  }
}

TEST_CASE("the polynomials of the first ratios are irreducible", "[exam]") {
  const GiNaC::symbol x("x");
  for (long k = 1; k <= 12; ++k)
    for (const Polynomial& p : {magic_polynomial(k), deficient_polynomial(k)}) {
      INFO(to_text(p));
      CHECK(GiNaC::is_a<GiNaC::numeric>(
          GiNaC::quo(expression(p, x), GiNaC::factor(expression(p, x)), x)));
      const GiNaC::ex factored = GiNaC::factor(expression(p, x));
      CHECK_FALSE(GiNaC::is_a<GiNaC::power>(factored));
      if (GiNaC::is_a<GiNaC::mul>(factored))
        for (const GiNaC::ex& part : factored)
          CHECK((!part.has(x) || part.degree(x) == p.degree()));
    }
  // and the same look at a reducible polynomial sees it
  CHECK(GiNaC::is_a<GiNaC::mul>(GiNaC::factor(
      (expression(magic_polynomial(3), x) * expression(magic_polynomial(4), x)).expand())));
}

TEST_CASE("well-known polynomials", "[exam]") {
  CHECK(to_text(cyclotomic_polynomial(1)) == "x - 1");
  CHECK(to_text(cyclotomic_polynomial(12)) == "x^4 - x^2 + 1");
  CHECK(cyclotomic_polynomial(105).coefficients[7] == -2);  // the first other than 0 and +-1
  CHECK(to_text(cosine_polynomial(7), "y") == "y^3 + y^2 - 2*y - 1");
  CHECK(to_text(cosine_polynomial(1)) == "x - 2");
  CHECK(to_text(cosine_polynomial(2)) == "x + 2");
  CHECK(to_text(cosine_polynomial(4)) == "x");
  CHECK(to_text(magic_polynomial(1)) == "x - 1");
  CHECK(to_text(magic_polynomial(2)) == "x^2 + 4*x - 1");
  CHECK(to_text(deficient_polynomial(1)) == "x^2 + 2*x - 1");
  CHECK_THROWS_AS(secant_polynomial(4), magicmass::InvalidInput);
}

TEST_CASE("cyclotomic polynomials multiply to x^m - 1", "[exam]") {
  for (const long m : {1L, 12L, 60L, 105L, 128L}) {
    Polynomial rest;
    rest.coefficients.resize(static_cast<std::size_t>(m) + 1);
    rest.coefficients.front() = -1;
    rest.coefficients.back() = 1;
    for (long d = 1; d <= m; ++d)
      if (m % d == 0) rest = exact_quotient(rest, cyclotomic_polynomial(d));
    CHECK(rest == Polynomial{{1}});
  }
  CHECK_THROWS_AS(exact_quotient(Polynomial{{1, 0, 1}}, Polynomial{{1, 1}}), std::logic_error);
}
