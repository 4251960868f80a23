// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/formula_text.hpp"

#include <sstream>

#include <catch2/catch.hpp>

using namespace magicmass::render;

namespace {
const TextStyle unicode{.unicode = true};
const TextStyle ascii{};

std::string shown(const std::string& text) { return inline_text(formula(text), unicode); }
}  // namespace

TEST_CASE("columns are code points", "[exam]") {
  CHECK(columns("αψ√ₙ₋₁") == 6);
  CHECK(columns("") == 0);
}

TEST_CASE("formulas on one line", "[exam]") {
  CHECK(shown("a(n - 1)") == "aₙ₋₁");
  CHECK(shown("c'(n)") == "c′ₙ");
  CHECK(shown("t_P(n)") == "t_P(n)");
  CHECK(shown("a(N_A)") == "a(N_A)");
  CHECK(shown("2*V_CM*(1 + alpha)*cos((n + 1/2)*psi/2)") == "2V_CM (1 + α) cos[(n + ½)ψ/2]");
  CHECK(shown("-2*(1 - alpha)*sqrt(alpha)/(1 + alpha)^2") == "−2(1 − α) √α/(1 + α)²");
  CHECK(shown("x/(y*z)") == "x/(yz)");
  CHECK(shown("cos(theta)^2") == "cos²(θ)");
  CHECK(shown("e^(n/2)") == "e^(n/2)");
  CHECK(shown("e^(2*n)") == "e²ⁿ");
  CHECK(shown("ceil(pi/psi - 1/2)") == "⌈π/ψ − ½⌉");
  CHECK(shown("R lambda_3(n*psi) R^T") == "R λ₃(nψ) Rᵀ");
  CHECK(shown("factorial(2*k)") == "(2k)!");
  CHECK(shown("alpha_k") == "αₖ");
  CHECK(shown("a - (b - c)") == "a − (b − c)");
  CHECK(shown("(a + b)*2") == "(a + b)·2");
  CHECK(shown("sum((-1)^k'*sin(x)^(2*k'), 0, floor(n/2))") == "Σ[k = 0, …, ⌊n/2⌋] (−1)ᵏ sin(x)²ᵏ");
  CHECK(shown("lim(a(n), n)") == "lim[n → ∞] aₙ");
  CHECK(shown("n_A x n_B") == "n_A × n_B");
  CHECK(shown("x x^T") == "x xᵀ");
  CHECK(shown("d_A . n_B") == "d_A·n_B");
  CHECK(shown("(R R^T)_11") == "(R Rᵀ)₁₁");
  CHECK(shown("no such notation") == "no such notation");
  CHECK(inline_text(formula("a(n - 1)*sqrt(alpha)"), ascii) == "a(n - 1)*sqrt(alpha)");
}

TEST_CASE("a fraction over three lines, a matrix in tall brackets", "[exam]") {
  CHECK(display_text(equation("a(n)", "=", "V_CM*(1 + cos(n*psi)/cos(psi/2))"), unicode, 2) ==
        "            ⎛     cos(nψ)  ⎞\n"
        "  aₙ = V_CM ⎜1 + ──────────⎟\n"
        "            ⎝     cos(ψ/2) ⎠\n");
  CHECK(display_text(equation("M", "=", "[[1, alpha], [sqrt(alpha), -1/2]]"), unicode, 0) ==
        "M = ⎡1   α ⎤\n"
        "    ⎣√α  −½⎦\n");
  CHECK(display_text(equation("x", "=", "-1/(1 + y)"), ascii, 0) ==
        "         1\n"
        "x = - -------\n"
        "       1 + y\n");
}

TEST_CASE("whatever is wide is broken within 80 columns", "[exam]") {
  std::string sum = "x_1";
  for (int i = 2; i < 60; ++i) sum += (i % 3 == 0 ? " - y_" : " + x_") + std::to_string(i);
  std::string product = "x";
  for (int i = 0; i < 40; ++i) product += "*cos(" + std::to_string(i + 2) + "*psi)";
  const std::string row = "[" + sum.substr(0, 60) + "x, " + sum.substr(0, 60) + "x]";
  for (const std::string& side : {sum, product, "(" + sum + ")/(1 + alpha)", "sqrt(" + sum + ")",
                                  "[" + row + ", " + row + "]", "cos(" + sum + ")*(" + sum + ")"})
    for (const TextStyle& style : {unicode, ascii}) {
      std::istringstream lines(display_text(equation("a(n)", "=", side), style, 4));
      for (std::string line; std::getline(lines, line);) {
        INFO(line);
        CHECK(columns(line) <= 80);
      }
    }
}
