// SPDX-License-Identifier: GPL-2.0-or-later
// MathML: what is set above, below or beside what.
#include "render/mathml.hpp"

#include "catch.hpp"

using namespace kernel;

TEST_CASE("MathML of terms and formulas") {
  const Expr a = real("alpha"), x = real("x"), y = real("y");
  struct Row {
    Expr formula;
    std::string mathml;
  };
  const Row rows[] = {
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
  for (const Row& row : rows)
    CHECK(render::mathml(row.formula, false) == "<math>" + row.mathml + "</math>");
  CHECK(render::mathml(x, true) == "<math display=\"block\"><mi>x</mi></math>");
}
