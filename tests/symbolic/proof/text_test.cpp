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
  CHECK(to_text(V_CM * (1 + cos(n * psi) / cos(psi / 2))) == "V_CM*(1 + cos(n*psi)/cos(psi/2))");
  CHECK(to_text(V_CM * (1 - cos(psi))) == "V_CM*(1 - cos(psi))");
  CHECK(to_text((1 - alpha) / (1 + alpha)) == "(1 - alpha)/(1 + alpha)");
  CHECK(to_text(pow(alpha - 1, 2)) == "(1 - alpha)^2");
  CHECK(to_text(-2 * alpha / 3) == "-2*alpha/3");
  CHECK(to_text(sqrt(alpha / (2 + alpha))) == "sqrt(alpha/(2 + alpha))");
  CHECK(to_text(a(n - 1)) == "a(n - 1)");
  CHECK(to_text(c_prime(n)) == "c'(n)");
  CHECK(to_text(1 / (2 * k + 1)) == "1/(2*k + 1)");
  CHECK(to_text(GiNaC::matrix{{1, alpha}, {0, -1}}) == "[[1, alpha], [0, -1]]");
  CHECK(to_text(Statement(alpha, Relation::greater, 0)) == "alpha > 0");
}

TEST_CASE("a product of sums prints the same however GiNaC holds their signs", "[exam]") {
  const ex N_A = symbol("N_A"), psi = symbol("psi"), is_P = symbol("is_P");
  const std::string shown = "(1 - 2*is_P)*(pi - N_A*psi)/2";
  CHECK(to_text((1 - 2 * is_P) * (GiNaC::Pi - N_A * psi) / 2) == shown);
  CHECK(to_text((2 * is_P - 1) * (N_A * psi - GiNaC::Pi) / 2) == shown);
}

TEST_CASE("sums and products keep a physicist's order", "[exam]") {
  const ex alpha = symbol("alpha"), n = symbol("n"), psi = symbol("psi"), V = symbol("V"),
           L = symbol("L"), theta = symbol("theta"), e = symbol("e"), x = symbol("x"),
           m = symbol("m");
  CHECK(to_text(1 + 3 * pow(alpha, 2) + alpha) == "1 + alpha + 3*alpha^2");
  CHECK(to_text(pow(alpha, 2) + sqrt(alpha) - 1) == "sqrt(alpha) - 1 + alpha^2");
  CHECK(to_text((2 * n + 1) * psi / 4) == "(n + 1/2)*psi/2");
  CHECK(to_text(cos((4 * n - 1) * psi / 4)) == "cos((n - 1/4)*psi)");
  CHECK(to_text((n + 1) * psi / 2) == "(n + 1)*psi/2");
  CHECK(to_text(T(2 * n + 1)) == "T(2*n + 1)");
  CHECK(to_text(sin(theta) * cos(theta)) == "cos(theta)*sin(theta)");
  CHECK(to_text(c(n) - a(n)) == "c(n) - a(n)");
  CHECK(to_text((alpha * b(n) - b(n) - 2 * alpha * c(n)) / (1 + alpha)) ==
        "-(b(n) - alpha*b(n) + 2*alpha*c(n))/(1 + alpha)");
  CHECK(to_text((1 - alpha) * a(n - 1) + 2 * alpha * c_prime(n - 1)) ==
        "(1 - alpha)*a(n - 1) + 2*alpha*c'(n - 1)");
  CHECK(to_text(L * alpha * V * n * sin(psi) * cos(psi)) == "V*L*alpha*n*cos(psi)*sin(psi)");
  CHECK(to_text(sqrt(2 + alpha) * sqrt(alpha) * (1 + alpha)) ==
        "(1 + alpha)*sqrt(alpha)*sqrt(2 + alpha)");
  CHECK(to_text(2 * T(1) * T(m + 1) - T(m)) == "2*T(1)*T(m + 1) - T(m)");
  CHECK(to_text(GiNaC::Pi / psi - numeric(1, 2)) == "pi/psi - 1/2");
  CHECK(to_text(1 - cos(n * psi) + sqrt(alpha) * sin(n * psi)) ==
        "1 - cos(n*psi) + sqrt(alpha)*sin(n*psi)");
}

TEST_CASE("what is printed reads in one way only", "[exam]") {
  const ex x = symbol("x"), n = symbol("n"), m = symbol("m");
  CHECK(to_text(pow(x, numeric(2, 3))) == "x^(2/3)");
  CHECK(to_text(pow(pow(x, n), m)) == "(x^n)^m");
  CHECK(to_text(pow(x, n + 1)) == "x^(n + 1)");
  CHECK(to_text(pow(x, n / 2)) == "x^(n/2)");
  CHECK(to_text(pow(-1, n) * x) == "(-1)^n*x");
  CHECK(to_text(sqrt(pow(x, 3))) == "sqrt(x^3)");
  CHECK(to_text(pow(x, -numeric(3, 2))) == "1/sqrt(x)^3");
  CHECK(to_text(-(1 - x)) != to_text(1 - x));
}
