// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/formula_latex.hpp"

#include <catch2/catch.hpp>

using namespace magicmass::render;

namespace {
std::string shown(const std::string& text) { return latex(formula(text)); }
}  // namespace

TEST_CASE("LaTeX of small formulas", "[exam]") {
  CHECK(shown("V_CM*(1 + cos(n*psi)/cos(psi/2))") ==
        "V_{\\mathrm{CM}} \\left( 1 + \\frac{\\cos(n \\psi)}{\\cos(\\psi / 2)} \\right)");
  CHECK(shown("c'(n - 1)") == "c'_{n - 1}");
  CHECK(shown("t_P(n)") == "t_{P_{n}}");
  CHECK(shown("cos(theta)*sin(theta)") == "\\cos \\theta \\, \\sin \\theta");
  CHECK(shown("sin((n + 1/2)*psi)") == "\\sin[(n + \\tfrac{1}{2}) \\psi]");
  CHECK(shown("sqrt(2 + alpha)^3") == "(2 + \\alpha)^{3/2}");
  CHECK(shown("det Gamma_A") == "\\operatorname{det} \\, \\Gamma_{A}");
  CHECK(shown("cos(x)^(n - 2*k)") == "\\cos^{n - 2 k} x");
  CHECK(shown("e^n") == "e^{n}");
  CHECK(shown("(x^2)^n") == "(x^{2})^{n}");
  CHECK(latex(equation("x", "!=", "0")) == "x \\neq 0");
  CHECK(shown("what is {this}?") == "\\text{what is \\{this\\}?}");
}

TEST_CASE("text is escaped for LaTeX", "[exam]") {
  CHECK(latex_escaped("50% of $x_1 & {#}~^\\") ==
        "50\\% of \\$x\\_1 \\& \\{\\#\\}\\textasciitilde{}\\textasciicircum{}\\textbackslash{}");
}

TEST_CASE("a wide equation is broken, a narrow one is not", "[exam]") {
  std::string sum = "x_1";
  for (int i = 2; i < 40; ++i) sum += " + x_" + std::to_string(i);
  CHECK(latex_display(equation("y", "=", "x + 1"), 38) == "y = x + 1");
  const std::string broken = latex_display(equation("y", "=", sum), 38);
  CHECK(broken.starts_with("\\begin{aligned}"));
  CHECK(broken.find("\\\\\n") != std::string::npos);
  // what moves out of a numerator keeps its sign and its parentheses
  const std::string moved = latex_display(equation("y", "=", "-(" + sum + ")/(1 + alpha)"), 38);
  CHECK(moved.find("= - \\frac{1}{1 + \\alpha} \\big") != std::string::npos);
}
