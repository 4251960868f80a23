// Formulas in LaTeX, with parentheses where the reading would change, and nowhere else; in MathML,
// what is set above, below or beside what. Pages are seen in the sessions of the command.
#include "notation/typed.hpp"
#include "render/pages.hpp"
#include "rows.hpp"

TEST_CASE("LaTeX and MathML of terms and formulas") {
  for (const char* name : {"alpha", "x", "y", "u_1", "V_CM", "c'", "delta_e", "share_e"})
    kernel::real(name);
  kernel::integer("n");
  for (const auto& row : rows_of("symbolic/render/formulas.tsv", 3, 36)) {
    const kernel::Expr formula = notation::read(row[0]);
    INFO(row[0]);
    if (!row[1].empty()) CHECK(render::latex(formula) == row[1]);
    if (!row[2].empty()) CHECK(render::mathml(formula, false) == "<math>" + row[2] + "</math>");
  }
}
TEST_CASE("names in words are set as in formulas, and signs of a page's own are escaped") {
  const std::vector<render::Section> pages{{"50% of a_b, alpha & P_(n+1) #1^2", {}, {}}};
  CHECK_THAT(render::latex_page(pages),
             ContainsSubstring(R"(\section{50\% of $a_{b}$, $\alpha$ \& $P_{n+1}$ \#1\^{}2})"));
  CHECK_THAT(render::html_body(pages),
             ContainsSubstring("</math>, <math><mi>α</mi></math> &amp; <math><msub>"));
}
