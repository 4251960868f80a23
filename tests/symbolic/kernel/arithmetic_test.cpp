// Attacks on arithmetic: certificates that do not certify, beside those that do.
#include "attack.hpp"
#include "rows.hpp"

using namespace kernel;

namespace {
const std::set<std::string> uses{"nonzero", "multiplier", "equation", "square", "product"};
/// Of pairs of fields from the third on.
Certificate certificate(const std::vector<std::string>& row) {
  Certificate out;
  for (std::size_t k = 2; k < row.size() && !row[k].empty(); k += 2) {
    const std::string& use = row[k];
    const Exprs all = listed(row[k + 1]);
    REQUIRE(uses.contains(use));
    if (use == "nonzero") out.nonzero.push_back(assume(all.at(0)));
    if (use == "multiplier") out.multipliers.push_back(assume(all.at(0)));
    if (use == "equation") out.equations.emplace_back(all.at(0), assume(all.at(1)));
    if (use == "square") out.products.push_back({all.at(0).value(), {}, {all.at(1)}});
    if (use != "product") continue;
    Certificate::Product product{all.at(0).value()};
    for (std::size_t i = 1; i < all.size(); ++i) product.factors.push_back(assume(all[i]));
    out.products.push_back(product);
  }
  return out;
}
}  // namespace

TEST_CASE("certificates prove, under all their hypotheses, or do not, as in certificates.tsv") {
  for (const auto& row : rows_of("symbolic/kernel/certificates.tsv", 8, 49)) {
    const Expr goal = notation::read(row[1]);
    const Certificate by = certificate(row);
    INFO(row[1] << ", " << row[2] << " " << row[3]);
    if (!std::isdigit(row[0][0])) {
      refused(row[1], row[0], [&] { arithmetic(goal, by); });
      continue;
    }
    const Theorem t = arithmetic(goal, by);
    CHECK(t.conclusion() == goal);
    CHECK(std::to_string(t.hypotheses().size()) == row[0]);
  }
  const Expr loose = all(x, eq(x, 0)).arg(0).arg(0);
  const auto by = [](const Certificate& c) { return [=] { arithmetic(le(0, 0), c); }; };
  refused("a loose cofactor", "must be a term", by({.equations = {{loose, nought}}}));
  refused("a loose square", "only a term", by({.products = {{1, {}, {loose}}}}));
}
