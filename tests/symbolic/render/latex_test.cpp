// SPDX-License-Identifier: GPL-2.0-or-later
// Formulas in LaTeX: parentheses where the reading would change, and nowhere else.
#include "render/latex.hpp"

#include "catch.hpp"

using namespace kernel;

TEST_CASE("LaTeX of terms and formulas") {
  const Expr a = real("alpha"), x = real("x"), y = real("y"), n = integer("n");
  struct Row {
    Expr formula;
    std::string latex;
  };
  const Row rows[] = {
      {a, "\\alpha"},
      {real("u_1"), "u_{1}"},
      {real("V_CM"), "V_{\\mathrm{CM}}"},
      {1 / (1 + a), "\\frac{1}{1 + \\alpha}"},
      {(1 - a) / (1 + a), "\\frac{1 - \\alpha}{1 + \\alpha}"},
      {x * (1 + y), "x \\, \\left(1 + y\\right)"},
      {x / (y * (1 + a)), "\\frac{x}{y \\, \\left(1 + \\alpha\\right)}"},
      {x - (y - a), "x - \\left(y - \\alpha\\right)"},
      {x + (-y), "x - y"},
      {-x * y, "-x \\, y"},
      {power(1 + x, 2), "\\left(1 + x\\right)^{2}"},
      {power(sqrt(x), 2), "\\sqrt{x}^{2}"},
      {-power(x, 2), "-x^{2}"},
      {power(-x, 2), "\\left(-x\\right)^{2}"},
      {Expr(cln::cl_RA(1) / 2) * x, "\\frac{x}{2}"},
      {x + Expr(cln::cl_RA(-1) / 2), "x - \\frac{1}{2}"},
      {2 * x, "2 \\, x"},
      {2 * (3 * x), "6 \\, x"},
      {ceil(x / 2), "\\left\\lceil \\frac{x}{2}\\right\\rceil"},
      {cos(n * x) / cos(x / 2),
       "\\frac{\\cos\\left(n \\, x\\right)}{\\cos\\left(\\frac{x}{2}\\right)}"},
      {le(x, y), "x \\le y"},
      {neq(x, y), "x \\ne y"},
      {logic_and({lt(x, y), logic_or({lt(y, a), eq(x, a)})}),
       "x < y,\\quad \\left(y < \\alpha\\text{ or }x = \\alpha\\right)"},
      {imp(lt(x, y), imp(lt(y, a), lt(x, a))),
       "x < y \\implies \\left(y < \\alpha \\implies x < \\alpha\\right)"},
      {matrix(2, {1, 0, x, -y}), "\\begin{pmatrix}1 & 0 \\\\ x & -y\\end{pmatrix}"},
      {transpose(matrix(1, {x, y})), "\\begin{pmatrix}x \\\\ y\\end{pmatrix}^{T}"},
      {all(x, le(0, power(x, 2))), "\\text{for every real }x: 0 \\le x^{2}"},
  };
  for (const Row& row : rows) CHECK(render::latex(row.formula) == row.latex);
}
