// SPDX-License-Identifier: GPL-2.0-or-later
// Each theorem of the book at random points, and false statements beside true ones that are seen;
// the paper's labels.
#include "net.hpp"

#include <iterator>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "kernel/print.hpp"
#include "notation/read.hpp"
#include "rows.hpp"

using derivation::the_book;

TEST_CASE("each theorem is true at random points that satisfy its hypotheses") {
  for (const auto& chapter : the_book().chapters())
    for (const auto& s : chapter.statements) {
      INFO(s.id << ": " << kernel::text(s.theorem));
      const net::Tried t = net::tried(s.theorem.hypotheses(), s.theorem.conclusion(), 100);
      CHECK(t.false_at == "");
      CHECK(t.points >= (kernel::free_variables(s.theorem.conclusion()).empty() ? 1 : 100));
    }
}

TEST_CASE("false statements are seen") {
  const auto rows = rows_of("symbolic/derivation/false.tsv", 3);
  REQUIRE(rows.size() > 80);
  for (const auto& row : rows) {
    const kernel::Theorem theorem = the_book()[row[0]];
    std::string words = kernel::text(theorem.conclusion());
    const std::size_t at = words.find(row[1]);
    INFO(row[0] << ": " << row[2] << " in " << words);
    REQUIRE(at != std::string::npos);
    words.replace(at, row[1].size(), row[2]);
    CHECK_FALSE(net::tried(theorem.hypotheses(), notation::read(words), 400).false_at.empty());
  }
}

TEST_CASE("hypotheses that nothing satisfies are seen") {
  const kernel::Expr alpha = kernel::real("alpha");
  const kernel::Exprs impossible{kernel::lt(alpha, 0), kernel::lt(0, alpha)};
  CHECK(net::tried(impossible, kernel::eq(alpha, 1), 20).points == 0);
}

// All labels of the paper's equations and tables, in its order, sec:nx and sec:nhx for equations
// that have none; not table:akbk, which claims nothing: its decimals are computed.
TEST_CASE("each label of the paper has a statement, and no statement has another") {
  const std::string paper =
      "NA-range NB-range def:Vn eq:conservation eq:ac eq:Euc-Pn eq:bcp eq:Euc-Qn "
      "eq:energy-conservation-PnQn eq:Euc-Pn-linear eq:Euc-Qn-linear eq:V2 eq:V-n eq:V-n-0 "
      "eq:Lam-G-G theta-txt eq:Lambda eq:Lambda-n-final-txt def:psi eq:a-final eq:b-final "
      "eq:c-final eq:c'-final eq:NANB-ans-txt eq:Naatcritical eq:Nbatcritical exact:ak "
      "exact:bk eq:a-terminal eq:b-terminal eq:ct eq:inelastic eq:lambda-1 eq:lambda-2 eq:lambda-3 "
      "eq:lambda-n def:R eq:abc-n eq:abcp-n eq:Gamma def:gamma def:theta eq:V-n-app "
      "eq:V-n-0-app Lam-GAM eq:Lambda-app eq-app:lambda-R eq:Lambda-n-final eq:R-app "
      "def:psi-app sec:nx sec:nhx def:ceil def:floor def:sawtooth eq:NA-constraint "
      "eq:NA-constraint-simple eq:NA-ans eq:NB-constraint eq:NB-constraint-simple "
      "eq:NB-ans eq:NANB-ans eq:NA-approx eq:magic-b-cond eq:magic-b-cond-simple "
      "eq:defb-terminal eq:def-b-cond table:trig";
  const auto words = [](const std::string& text) {
    std::istringstream in(text);
    return std::set<std::string>(std::istream_iterator<std::string>(in), {});
  };
  std::string claimed;
  for (const auto& chapter : the_book().chapters())
    for (const auto& s : chapter.statements) claimed += s.label + " ";
  CHECK(words(claimed) == words(paper));
  CHECK(words(paper).size() == 68);
}
