// SPDX-License-Identifier: GPL-2.0-or-later
// Each theorem of the book at random points, and false statements beside true ones that are seen;
// the paper's labels.
#include "net.hpp"

#include "catch.hpp"
#include "notation/typed.hpp"
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

TEST_CASE("each label of the paper has a statement, and no statement has another") {
  std::set<std::string> paper, claimed;
  for (const auto& row : rows_of("symbolic/derivation/labels.tsv", 1)) paper.insert(row[0]);
  for (const auto& chapter : the_book().chapters())
    for (const auto& s : chapter.statements) {
      std::istringstream labels(s.label);
      for (std::string label; labels >> label;) claimed.insert(label);
    }
  CHECK(claimed == paper);
  CHECK(paper.size() == 68);
}
