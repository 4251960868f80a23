// SPDX-License-Identifier: GPL-2.0-or-later
// Pages of a derivation.
#include "render/pages.hpp"

#include <sstream>

#include "catch.hpp"

using namespace kernel;

namespace {
std::vector<render::Section> sections() {
  const Expr x = real("x"), y = real("y");
  const Expr product = eq(x * y, y * x);
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
