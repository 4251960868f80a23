// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/text.hpp"

#include <catch2/catch.hpp>
#include <ginac/ginac.h>

#include "proof/names.hpp"

using namespace magicmass::proof;
using GiNaC::ex;
using GiNaC::numeric;

TEST_CASE("expressions print as a physicist orders them", "[exam]") {
  const ex alpha = symbol("alpha"), n = symbol("n"), psi = symbol("psi"), V_CM = symbol("V_CM"),
           k = symbol("k");
  CHECK(text(V_CM * (1 + cos(n * psi) / cos(psi / 2))) == "V_CM*(1 + cos(n*psi)/cos(psi/2))");
  CHECK(text(V_CM * (1 - cos(psi))) == "V_CM*(1 - cos(psi))");
  CHECK(text((1 - alpha) / (1 + alpha)) == "(1 - alpha)/(1 + alpha)");
  CHECK(text(pow(alpha - 1, 2)) == "(1 - alpha)^2");
  CHECK(text(-2 * alpha / 3) == "-2*alpha/3");
  CHECK(text(sqrt(alpha / (2 + alpha))) == "sqrt(alpha/(2 + alpha))");
  CHECK(text(a(n - 1)) == "a(n - 1)");
  CHECK(text(c_prime(n)) == "c'(n)");
  CHECK(text(1 / (2 * k + 1)) == "1/(2*k + 1)");
  CHECK(text(GiNaC::matrix{{1, alpha}, {0, -1}}) == "[[1, alpha], [0, -1]]");
  CHECK(text(Statement(alpha, Relation::greater, 0)) == "alpha > 0");
}
