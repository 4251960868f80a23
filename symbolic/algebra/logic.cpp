// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebra/logic.hpp"

namespace algebra {
Theorem use(const Theorem& rule, const Substitution& terms, const Theorems& premises) {
  const Theorem t = terms.empty() ? rule : instantiate(rule, terms);
  if (t.conclusion().op() != Op::Imp || premises.empty()) return t;
  return tautology(t.conclusion().arg(1), premises + Theorems{t});
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
  return tautology(theorem.conclusion(), from + Theorems{theorem});
}
Theorem cut(const Theorem& proof, const Theorem& theorem) {
  return tautology(theorem.conclusion(), {discharge(proof.conclusion(), theorem), proof});
}
Theorem next_integer(const Theorem& less) {
  const Expr i = less.conclusion().arg(0);
  const Expr j = less.conclusion().arg(1);
  return tautology(le(i + 1, j), {use("discrete", {{integer("i"), i}, {integer("j"), j}}), less});
}
}  // namespace algebra
