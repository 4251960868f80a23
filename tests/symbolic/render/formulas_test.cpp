// SPDX-License-Identifier: GPL-2.0-or-later
// Formulas in LaTeX, with parentheses where the reading would change, and nowhere else; in MathML,
// what is set above, below or beside what.
#include "catch.hpp"
#include "render/latex.hpp"
#include "render/mathml.hpp"

using namespace kernel;

namespace {
const Expr a = real("alpha"), x = real("x"), y = real("y"), n = integer("n");
using Rows = std::vector<std::pair<Expr, std::string>>;
}  // namespace

TEST_CASE("LaTeX of terms and formulas") {
  const Rows rows{
      {a, "\\alpha"},
      {real("u_1"), "u_{1}"},
      {real("V_CM"), "V_{\\mathrm{CM}}"},
      {1 / (1 + a), "\\frac{1}{1 + \\alpha}"},
      {(1 - a) / (1 + a), "\\frac{1 - \\alpha}{1 + \\alpha}"},
      {x * (1 + y), "x \\, \\left(1 + y\\right)"},
      {x / (y * (1 + a)), "\\frac{x}{y \\, \\left(1 + \\alpha\\right)}"},
      {(1 + x) / 2, "\\frac{1 + x}{2}"},
      {2 * (1 + x) / y, "\\frac{2 \\, \\left(1 + x\\right)}{y}"},
      {power(real("c'"), 2), "{c'}^{2}"},
      {real("delta_e"), "\\delta_{e}"},
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
      {x * power(Expr(3), 2), "x \\cdot 3^{2}"},
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
  for (const auto& [formula, latex] : rows) CHECK(render::latex(formula) == latex);
}

TEST_CASE("MathML of terms and formulas") {
  const Rows rows{
      {a, "<mi>α</mi>"},
      {real("u_1"), "<msub><mrow><mi>u</mi></mrow><mrow><mn>1</mn></mrow></msub>"},
      {x / y, "<mfrac><mrow><mi>x</mi></mrow><mrow><mi>y</mi></mrow></mfrac>"},
      {-power(x, 2), "<mo>−</mo><msup><mrow><mi>x</mi></mrow><mrow><mn>2</mn></mrow></msup>"},
      {x - y, "<mi>x</mi><mo>−</mo><mi>y</mi>"},
      {2 * x, "<mn>2</mn><mo>&#x2062;</mo><mi>x</mi>"},
      {lt(x, y), "<mi>x</mi><mo>&lt;</mo><mi>y</mi>"},
      {sqrt(x), "<msqrt><mi>x</mi></msqrt>"},
      {cos(x), "<mi>cos</mi><mo>&#x2061;</mo><mrow><mo>(</mo><mi>x</mi><mo>)</mo></mrow>"},
      {logic_and({lt(x, y), lt(y, a)}),
       "<mi>x</mi><mo>&lt;</mo><mi>y</mi><mtext>&#xa0;and&#xa0;</mtext>"
       "<mi>y</mi><mo>&lt;</mo><mi>α</mi>"},
      {matrix(1, {1, x}),
       "<mrow><mo>(</mo><mtable><mtr><mtd><mn>1</mn></mtd></mtr><mtr><mtd><mi>x</mi></mtd></mtr>"
       "</mtable><mo>)</mo></mrow>"},
  };
  for (const auto& [formula, mathml] : rows)
    CHECK(render::mathml(formula, false) == "<math>" + mathml + "</math>");
  CHECK(render::mathml(x, true) == "<math display=\"block\"><mi>x</mi></math>");
}
