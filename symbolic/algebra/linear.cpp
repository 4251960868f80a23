// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebra/linear.hpp"

#include <algorithm>

#include "algebra/equations.hpp"
#include "kernel/polynomial.hpp"
#include "kernel/print.hpp"

namespace algebra {
namespace {
using cln::cl_RA;

/// p > 0 or p >= 0 with the combination of given rows that it is: row 0 is the negated goal, row i
/// the fact i - 1.
struct Row {
  Polynomial p;
  std::vector<cl_RA> of;
  bool strict;

  cl_RA coefficient(const Monomial& m) const {
    const auto it = p.find(m);
    return it == p.end() ? cl_RA(0) : it->second;
  }
  bool is_constant() const {
    return std::all_of(p.begin(), p.end(), [](const auto& term) { return term.first.empty(); });
  }
};
Row combined(const Row& a, const cl_RA& x, const Row& b, const cl_RA& y) {
  Row sum{scaled(a.p, x) + scaled(b.p, y), a.of, a.strict || b.strict};
  for (std::size_t i = 0; i < sum.of.size(); ++i) sum.of[i] = x * a.of[i] + y * b.of[i];
  return sum;
}

/// Takes the unknown that each equation leads with out of all other rows.
void eliminate_equations(std::vector<Row>& equations, std::vector<Row>& inequalities) {
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const Row e = equations[i];
    const auto lead =
        std::find_if(e.p.begin(), e.p.end(), [](const auto& term) { return !term.first.empty(); });
    if (lead == e.p.end()) continue;
    const auto take_out = [&](Row& row) {
      const cl_RA q = row.coefficient(lead->first);
      if (q == 0) return;
      const bool strict = row.strict;
      row = combined(row, 1, e, -q / lead->second);
      row.strict = strict;
    };
    for (Row& row : inequalities) take_out(row);
    for (std::size_t j = 0; j < equations.size(); ++j)
      if (j != i) take_out(equations[j]);
  }
}
/// One unknown less, the one that makes the fewest new rows; false where there is none left.
bool eliminate_unknown(std::vector<Row>& rows) {
  std::map<Monomial, std::pair<std::size_t, std::size_t>> signs;
  for (const Row& row : rows)
    for (const auto& [m, q] : row.p)
      if (!m.empty()) ++(q > 0 ? signs[m].first : signs[m].second);
  if (signs.empty()) return false;
  const auto product = [](const auto& entry) { return entry.second.first * entry.second.second; };
  const auto best = std::min_element(signs.begin(), signs.end(), [&](const auto& a, const auto& b) {
    return product(a) < product(b);
  });
  const Monomial unknown = best->first;
  std::vector<Row> rest;
  std::vector<Row> above;
  std::vector<Row> below;
  for (const Row& row : rows) {
    const cl_RA q = row.coefficient(unknown);
    (q > 0 ? above : q < 0 ? below : rest).push_back(row);
  }
  for (const Row& a : above)
    for (const Row& b : below)
      rest.push_back(combined(a, 1 / a.coefficient(unknown), b, -1 / b.coefficient(unknown)));
  rows = rest;
  return true;
}
/// A constant row that is false: of[0] (-D) + sum of facts = c, so D = (sum - c)/of[0]; with of[0]
/// = 0 the facts contradict each other.
Theorem from_contradiction(const Row& row, Expr goal, const Theorems& facts) {
  const bool absurd = row.of[0] == 0;
  const cl_RA scale = absurd ? cl_RA(1) : row.of[0];
  Certificate certificate;
  for (std::size_t i = 1; i < row.of.size(); ++i) {
    if (row.of[i] == 0) continue;
    const cl_RA q = row.of[i] / scale;
    if (facts[i - 1].conclusion().op() == Op::Eq)
      certificate.equations.emplace_back(Expr(q), facts[i - 1]);
    else
      certificate.products.push_back({q, {facts[i - 1]}, {}});
  }
  const cl_RA c = row.coefficient({});
  if (c != 0) certificate.products.push_back({-c / scale, {}, {}});
  if (!absurd) return arithmetic(goal, certificate);
  return tautology(goal, {arithmetic(lt(0, 0), certificate), never()});
}
Theorem inequality(Expr goal, const Theorems& facts) {
  const std::size_t count = facts.size() + 1;
  std::vector<Row> rows;
  std::vector<Row> equations;
  const auto unit = [&](std::size_t i) {
    std::vector<cl_RA> v(count, 0);
    v[i] = 1;
    return v;
  };
  rows.push_back({polynomial(goal.arg(0) - goal.arg(1)), unit(0), goal.op() == Op::Le});
  for (std::size_t i = 1; i < count; ++i) {
    const Theorem& fact = facts[i - 1];
    const Op op = fact.conclusion().op();
    if (op != Op::Eq && op != Op::Lt && op != Op::Le)
      refuse("linear: neither an equation nor an inequality: " + text(fact.conclusion()));
    (op == Op::Eq ? equations : rows).push_back({polynomial(gap(fact)), unit(i), op == Op::Lt});
  }
  eliminate_equations(equations, rows);
  constexpr std::size_t most_rows = 3000;
  do {
    for (const Row& row : rows) {
      if (!row.is_constant()) continue;
      const cl_RA c = row.coefficient({});
      if (c < 0 || (c == 0 && row.strict)) return from_contradiction(row, goal, facts);
    }
  } while (rows.size() < most_rows && eliminate_unknown(rows));
  refuse("no linear combination of the facts gives " + text(goal));
}
}  // namespace

Theorem linear(Expr goal, const Theorems& facts) {
  if (goal.op() == Op::Eq) {
    const Expr l = goal.arg(0);
    const Expr r = goal.arg(1);
    const Theorem above = inequality(le(l, r), facts);
    const auto certificate = above.step().certificate;
    if (certificate && certificate->products.empty()) return arithmetic(goal, *certificate);
    return tautology(goal, {above, inequality(le(r, l), facts),
                            use("equal or less or greater", {{real("x"), l}, {real("y"), r}})});
  }
  if (goal.op() == Op::Not && goal.arg(0).op() == Op::Eq) {
    const Expr l = goal.arg(0).arg(0);
    const Expr r = goal.arg(0).arg(1);
    return tautology(goal, {inequality(lt(l, r), facts),
                            use("less is not equal", {{real("x"), l}, {real("y"), r}})});
  }
  return inequality(goal, facts);
}
}  // namespace algebra
