// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebra/logic.hpp"

#include <algorithm>

#include "algebra/equations.hpp"
#include "algebra/linear.hpp"

namespace algebra {
namespace {
Theorems& all_known() {
  static Theorems facts;
  return facts;
}
using Sides = std::set<std::pair<Expr, Expr>>;
/// The sides of each equation of terms in f, or else of each inequality.
void sides_in(Expr f, bool of_equations, Sides& out) {
  const Op op = f.op();
  const bool relation = of_equations ? op == Op::Eq : op == Op::Lt || op == Op::Le;
  if (relation && !is_matrix(f.arg(0)) && out.count({f.arg(1), f.arg(0)}) == 0)
    out.emplace(f.arg(0), f.arg(1));
  if (op == Op::Not || op == Op::And || op == Op::Or || op == Op::Imp || op == Op::Iff)
    for (const Expr& a : f.args()) sides_in(a, of_equations, out);
}
}  // namespace

Exprs conjuncts(Expr f) { return f.op() == Op::And ? f.args() : Exprs{f}; }
bool is_among(Expr f, const Exprs& formulas) {
  return std::find(formulas.begin(), formulas.end(), f) != formulas.end();
}
Known::Known(const Theorems& facts) : before(all_known().size()) {
  for (const Theorem& t : facts) know(t);
}
Known::~Known() {
  all_known().erase(all_known().begin() + std::ptrdiff_t(before), all_known().end());
}
void know(const Theorem& fact) {
  for (const Theorem& t : parts({fact})) all_known().push_back(t);
}
const Theorems& known() { return all_known(); }
Theorems parts(const Theorems& theorems) {
  Theorems out;
  for (const Theorem& t : theorems) {
    const Expr f = t.conclusion();
    if (f.op() == Op::And)
      for (std::size_t i = 0; i < f.size(); ++i) out = out + parts({part(t, i)});
    else if (f.op() == Op::Eq && is_matrix(f.arg(0)))
      out = out + entries(t);
    else
      out.push_back(t);
  }
  return out;
}
Theorem use(const Theorem& rule, const Substitution& terms, const Theorems& premises) {
  const Theorem t = terms.empty() ? rule : instantiate(rule, terms);
  if (t.conclusion().op() != Op::Imp || premises.empty()) return t;
  const Theorems given = parts(premises);
  Theorems from = premises;
  for (const Expr& f : conjuncts(left(t)))
    if (std::none_of(given.begin(), given.end(),
                     [&](const Theorem& g) { return g.conclusion() == f; }) &&
        (f.op() == Op::Lt || f.op() == Op::Le || f.op() == Op::Eq))
      from.push_back(linear(f, premises));
  return tautology(right(t), from + Theorems{t});
}
Theorem at(const Theorem& t, const Substitution& terms, const Theorems& facts) {
  Theorem out = instantiate(t, terms);
  const Exprs before = t.hypotheses();
  for (const Expr& h : out.hypotheses())
    if (!is_among(h, before) && (h.op() == Op::Lt || h.op() == Op::Le || h.op() == Op::Eq))
      out = cut(linear(h, facts), out);
  return out;
}
Theorem given(Expr f, const std::function<Theorem(const Theorem&)>& body) {
  return discharge(f, body(assume(f)));
}
Theorem equivalent(Expr f, Expr g, const std::function<Theorem(const Theorem&)>& forth,
                   const std::function<Theorem(const Theorem&)>& back) {
  return tautology(iff(f, g), {given(f, forth), given(g, back)});
}
Theorem follows(Expr goal, const Theorems& from) {
  Sides sides;
  for (const bool of_equations : {true, false}) {
    sides_in(goal, of_equations, sides);
    for (const Theorem& t : from) sides_in(t.conclusion(), of_equations, sides);
  }
  Theorems all = from;
  for (const auto& [l, r] : sides) {
    all.push_back(use("equal or less or greater", {{real("x"), l}, {real("y"), r}}));
    const auto weaker = [&, l = l, r = r](Expr f) {
      const Expr up = le(l, r), down = le(r, l);
      const Expr goal_of_f = f.op() == Op::Eq ? logic_and({up, down}) : f == lt(l, r) ? up : down;
      all.push_back(given(f, [&](const Theorem& t) { return linear(goal_of_f, {t}); }));
    };
    for (const Expr& f : {lt(l, r), eq(l, r), lt(r, l)}) weaker(f);
  }
  return tautology(goal, all);
}
Theorem use(const std::string& axiom_name, const Substitution& terms, const Theorems& premises) {
  return use(axiom(axiom_name), terms, premises);
}
Theorem part(const Theorem& conjunction, std::size_t i) {
  return tautology(conjunction.conclusion().arg(i), {conjunction});
}
Theorem both(const Theorems& theorems) {
  Exprs formulas;
  for (const Theorem& t : theorems) formulas.push_back(t.conclusion());
  return tautology(logic_and(formulas), theorems);
}
Theorems operator+(Theorems a, const Theorems& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
Theorem never() {
  static const Theorem result = tautology(
      logic_not(lt(0, 0)),
      {use("less is not equal", {{real("x"), 0}, {real("y"), 0}}), arithmetic(eq(0, 0), {})});
  return result;
}
Theorem refute(Expr f, const Theorem& absurd) {
  return tautology(logic_not(f), {discharge(f, absurd), never()});
}
Theorem by_induction(Expr n, Expr f, const Theorem& base,
                     const std::function<Theorem(const Theorem&, const Theorem&)>& step) {
  const Expr premise = logic_and({le(0, n), f});
  const Theorem known = assume(premise);
  const Theorem next =
      discharge(premise, cut(part(known, 0), step(part(known, 0), part(known, 1))));
  return tautology(f, {induction(n, 0, f, base, next), assume(le(0, n))});
}
Theorem otherwise(Expr goal, const Theorem& absurd) {
  const Expr l = goal.arg(0), r = goal.arg(1);
  return tautology(goal, {refute(goal.op() == Op::Lt ? le(r, l) : lt(r, l), absurd)});
}
Theorem under(const Exprs& hypotheses, const Theorem& theorem) {
  Theorems from;
  for (const Expr& h : hypotheses) from.push_back(assume(h));
  const Theorem shown = tautology(theorem.conclusion(), from + Theorems{theorem});
  return shown.hypotheses() == theorem.hypotheses() ? theorem : shown;
}
Theorem cut(const Theorem& proof, const Theorem& theorem) {
  return tautology(theorem.conclusion(), {discharge(proof.conclusion(), theorem), proof});
}
Theorem next_integer(const Theorem& less) {
  const Expr i = left(less);
  const Expr j = right(less);
  return tautology(le(i + 1, j), {use("discrete", {{integer("i"), i}, {integer("j"), j}}), less});
}
}  // namespace algebra
