// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/formula_mathml.hpp"

#include <catch2/catch.hpp>

using namespace magicmass::render;

TEST_CASE("MathML of small formulas", "[exam]") {
  CHECK(mathml(formula("alpha_k")) ==
        "<math><msub><mi>α</mi><mrow><mi>k</mi></mrow></msub></math>");
  CHECK(mathml(formula("c'(n)")) ==
        "<math><msubsup><mi>c</mi><mrow><mi>n</mi></mrow><mo>′</mo></msubsup></math>");
  CHECK(mathml(formula("x^2")) ==
        "<math><msup><mrow><mi>x</mi></mrow><mrow><mn>2</mn></mrow></msup></math>");
  // the exponent at the function's name, before its argument
  const std::string squared = mathml(formula("cos(psi)^2"));
  CHECK(squared.find("<msup><mi>cos</mi>") != std::string::npos);
  CHECK(squared.find("<mn>2</mn>") < squared.find("ψ"));
  CHECK(mathml(formula("2*(1 + x)")).find("stretchy=\"false\"") != std::string::npos);
  CHECK(mathml_display(equation("y", "=", "2*(1 + 1/x)")).find("stretchy") == std::string::npos);
  CHECK(mathml_display(equation("x", "=", "1/y"))
            .find("<mfrac><mrow><mn>1</mn></mrow><mrow><mi>y</mi></mrow></mfrac>") !=
        std::string::npos);
}

TEST_CASE("what is written into a page is escaped", "[exam]") {
  CHECK(html_escaped("<b a=\"1\">&'") == "&lt;b a=&quot;1&quot;&gt;&amp;&#39;");
  CHECK(mathml(formula("<script>")) == "<math><mtext>&lt;script&gt;</mtext></math>");
  CHECK(html_escaped(std::string("a\0b\x1b", 4)) == "ab");
}
