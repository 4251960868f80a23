// SPDX-License-Identifier: GPL-2.0-or-later
// Pages of a derivation.
#include "render/pages.hpp"

#include <sstream>

#include "catch.hpp"

using namespace kernel;

namespace {
std::vector<render::Section> sections() {
  const Expr x = real("x"), y = real("y"), product = eq(x * y, y * x);
  return {{"A chapter",
           {lt(0, x)},
           {{"a.first", "eq:first", "In words,", product, {}, "arithmetic", {}},
            {"a.second",
             "",
             "A long sentence that has more words than a line of eighty columns can hold, so that "
             "it is broken at a blank.",
             logic_and({product, lt(0, x)}),
             {lt(0, y)},
             "tautology",
             {"a.first"}}}}};
}
}  // namespace

TEST_CASE("a page of text has 80 columns, conditions before formulas, reasons after") {
  const std::string page = render::text_page(sections());
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 80);
  CHECK_THAT(page, ContainsSubstring("A chapter\n=========\nThroughout: 0 < x.\n"));
  CHECK_THAT(page, ContainsSubstring("    x*y = y*x\n  [a.first] (eq:first) by arithmetic\n"));
  CHECK_THAT(page, ContainsSubstring("  if 0 < y\n    x*y = y*x\n    0 < x\n"));
  CHECK_THAT(page, ContainsSubstring("  [a.second] by tautology from a.first\n"));
}
TEST_CASE("a page of Markdown has its formulas between dollars") {
  const std::string page = render::markdown_page(sections());
  CHECK_THAT(page, ContainsSubstring("## A chapter\n\nThroughout: $0 < x$.\n"));
  CHECK_THAT(page, ContainsSubstring("If $0 < y$:\n\n$$x \\, y = y \\, x$$\n"));
  CHECK_THAT(page, ContainsSubstring("`a.first` (eq:first): arithmetic\n"));
}
TEST_CASE("a page of HTML is well-formed, its premises are links") {
  const std::string page = render::html_page(sections());
  CHECK_THAT(page, ContainsSubstring("<h2>A chapter</h2>\n<p>Throughout: <math><mn>0</mn>"));
  CHECK_THAT(page, ContainsSubstring("<mo>&lt;</mo>"));
  CHECK_THAT(page, ContainsSubstring("<p id=\"a.second\">"));
  CHECK_THAT(page, ContainsSubstring("tautology from <a href=\"#a.first\">a.first</a></p>"));
  std::vector<std::string> open;
  for (std::size_t at = page.find('<', 15); at != page.npos; at = page.find('<', at + 1)) {
    const std::string tag = page.substr(at + 1, page.find_first_of(" >", at) - at - 1);
    if (tag == "meta") continue;
    if (tag[0] != '/') {
      open.push_back(tag);
      continue;
    }
    REQUIRE(!open.empty());
    CHECK(tag == "/" + open.back());
    open.pop_back();
  }
  CHECK(open.empty());
}
TEST_CASE("a page of LaTeX is a document, with signs of its own escaped") {
  const std::string page = render::latex_page(sections());
  CHECK(page.starts_with("\\documentclass"));
  CHECK(page.ends_with("\\end{document}\n"));
  CHECK_THAT(page, ContainsSubstring("\n\\section{A chapter}\n\nThroughout: $0 < x$.\n"));
  CHECK_THAT(page, ContainsSubstring("\\[x \\, y = y \\, x\\]\n"));
  auto odd = sections();
  odd[0].steps[0].id = "a.first_one";
  const Exprs many(80, real("x"));
  odd[0].steps[0].formula = eq(sum(many), 0);
  odd[0].steps[0].conditions = {eq(sum(many), 0)};
  CHECK_THAT(render::html_body(odd), ContainsSubstring("<p>If</p>\n<math display=\"block\">"));
  CHECK_THAT(render::latex_page(odd), ContainsSubstring("{\\raggedright $\\displaystyle x + x"));
  CHECK_THAT(render::latex_page(odd), ContainsSubstring("\\texttt{a.first\\_one}"));
}
