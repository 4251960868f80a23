// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/minimal_polynomial.hpp"

#include <catch2/catch.hpp>

#include "algebraic/constant.hpp"
#include "algebraic/ratio_polynomials.hpp"
#include "constants.hpp"

using namespace magicmass::algebraic;
using GiNaC::cos;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

std::string polynomial_of(const ex& constant) {
  const auto polynomial = minimal_polynomial(constant);
  return polynomial ? to_text(*polynomial) : "none";
}

}  // namespace

TEST_CASE("minimal polynomials of constants", "[exam]") {
  CHECK(polynomial_of(numeric(-3, 7)) == "7*x + 3");
  CHECK(polynomial_of(root(2)) == "x^2 - 2");
  CHECK(polynomial_of(root(5 + 2 * root(6))) == "x^4 - 10*x^2 + 1");
  CHECK(polynomial_of(root(2, 3) + root(3, 3)) == "x^9 - 15*x^6 - 87*x^3 - 125");
  CHECK(polynomial_of(1 / root(root(2) - 1, 7)) == "x^14 - 2*x^7 - 1");
  CHECK(polynomial_of(cos(Pi / 7) + cos(3 * Pi / 7) + cos(5 * Pi / 7)) == "2*x - 1");
  CHECK(polynomial_of(root(5 + 2 * root(6)) - root(2) - root(3)) == "x");
  CHECK(polynomial_of(GiNaC::pow(1 + root(2), 5)) == "x^2 - 82*x - 1");
  CHECK(polynomial_of(root(2) + root(3) + root(5) + root(7) + root(11)) == "none");
  CHECK(polynomial_of(cos(Pi / 1000003)) == "none");
  CHECK_THROWS_AS(minimal_polynomial(exp(ex(1))), NotAlgebraic);
}

TEST_CASE("ratios have the same polynomial by both ways", "[exam]") {
  for (long k = 1; k <= 8; ++k) {
    CHECK(minimal_polynomial(1 / cos(Pi / (2 * k + 1)) - 1) == magic_polynomial(k));
    CHECK(minimal_polynomial(1 / cos(Pi / (2 * (k + 1))) - 1) == deficient_polynomial(k));
  }
}

TEST_CASE("a constant in words is the only root with its decimals", "[exam]") {
  CHECK(as_root(root(5) - 2) == "the root near 0.2360 of x^2 + 4*x - 1");
  CHECK(as_root(1 / cos(Pi / 5) - 1) == "the root near 0.2360 of x^2 + 4*x - 1");
  CHECK(as_root(-root(5) - 2) == "the root near -4.2360 of x^2 + 4*x - 1");
  CHECK(as_root(cos(Pi / 7) + cos(3 * Pi / 7) + cos(5 * Pi / 7)) == "the rational number 1/2");
  // two roots that agree in the first 20 decimals
  const ex close = 1 + root(2) * numeric(10).power(-20);
  CHECK(as_root(close)->starts_with("the root near 1.0000000000000000000141421"));
}
