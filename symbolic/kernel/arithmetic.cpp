// Arithmetic by certificate, and induction.
#include <algorithm>

#include "kernel/polynomial.hpp"
#include "kernel/theorem.hpp"

namespace kernel {
namespace {

bool is(const Theorem& t, Op op) { return t.conclusion().op() == op; }
bool is_unequal(const Theorem& t) {
  return is(t, Op::Lt) || (is(t, Op::Not) && t.conclusion().arg(0).op() == Op::Eq);
}
// q - p of p = q, p < q, p <= q or not p = q
Polynomial difference(const Theorem& t) {
  Expr f = t.conclusion();
  if (f.op() == Op::Not) f = f.arg(0);
  return polynomial(f.arg(1)) - polynomial(f.arg(0));
}

Polynomial sum_of_equations(const Certificate& c) {
  Polynomial out;
  for (const auto& [cofactor, t] : c.equations) {
    if (!is(t, Op::Eq)) refuse("a cofactor belongs to an equation, not to " + text(t));
    if (!is_term(cofactor)) refuse("a cofactor must be a term");
    out = std::move(out) + polynomial(cofactor) * difference(t);
  }
  return out;
}
// At least 0: a coefficient >= 0 times proved inequalities times squares.
Polynomial value_of(const Certificate::Product& p) {
  if (p.coefficient < 0) refuse("a product's coefficient must be >= 0");
  Polynomial out = scaled(one(), p.coefficient);
  for (const Theorem& t : p.factors) {
    if (!is(t, Op::Lt) && !is(t, Op::Le)) refuse("a factor must be an inequality, not " + text(t));
    out = out * difference(t);
  }
  for (Expr root : p.roots) {
    if (!is_term(root)) refuse("only a term has a square");
    out = out * polynomial(root) * polynomial(root);
  }
  return out;
}
bool is_positive(const Certificate::Product& p) {
  return p.coefficient > 0 && p.roots.empty() &&
         std::ranges::all_of(p.factors, [](const Theorem& t) { return is(t, Op::Lt); });
}
Polynomial sum_of_products(Expr goal, const Certificate& c) {
  if (goal.op() == Op::Eq && !c.products.empty()) refuse("an equation follows from equations only");
  if (goal.op() == Op::Lt && std::none_of(c.products.begin(), c.products.end(), is_positive))
    refuse("no product is proved positive, so that < does not follow");
  Polynomial out;
  for (const auto& p : c.products) out = std::move(out) + value_of(p);
  return out;
}
Polynomial multiplier(Expr goal, const Certificate& c) {
  Polynomial out = one();
  for (const Theorem& t : c.multipliers) {
    if (!is(t, Op::Lt) && !(goal.op() == Op::Eq && is_unequal(t)))
      refuse("a multiplier must be proved positive (for an equation: not 0), not " + text(t));
    out = out * difference(t);
  }
  return out;
}

// The divisors by their canonical terms, each with both signs.
std::map<Expr, Polynomial> divisors(const Theorems& nonzero) {
  std::map<Expr, Polynomial> out;
  for (const Theorem& t : nonzero) {
    if (!is_unequal(t)) refuse("a divisor must be proved not 0, not " + text(t));
    const Polynomial d = difference(t);
    for (const Polynomial& p : {d, scaled(d, -1)}) out[expression(p)] = p;
  }
  return out;
}
// e times d^k, k the degree of e in inv(d): inv(d)^j d^k is d^(k-j), as d is not 0.
Polynomial without(const Polynomial& e, Expr inverse, const Polynomial& d) {
  int k = 0;
  for (const auto& [m, q] : e) k = std::max(k, degree(m, inverse));
  std::vector<Polynomial> powers{one()};
  for (int j = 0; j < k; ++j) powers.push_back(powers.back() * d);
  Polynomial out;
  for (const auto& [m, q] : e) {
    Monomial rest = m;
    std::erase_if(rest, [&](const auto& power) { return power.first == inverse; });
    out = std::move(out) + Polynomial{{rest, q}} * powers[std::size_t(k - degree(m, inverse))];
  }
  return out;
}
// 0 if and only if e is 0. The youngest inverse first: its d holds older atoms only, so this ends.
Polynomial cleared(Polynomial e, const Theorems& nonzero) {
  const std::map<Expr, Polynomial> known = divisors(nonzero);
  while (const Expr inverse = youngest_inverse(e, [&](Expr d) { return known.count(d) != 0; }))
    e = without(e, inverse, known.at(inverse.arg(0)));
  return e;
}

Theorems premises_of(const Certificate& c) {
  Theorems out = c.multipliers;
  out.insert(out.end(), c.nonzero.begin(), c.nonzero.end());
  for (const auto& [cofactor, t] : c.equations) out.push_back(t);
  for (const auto& p : c.products) out.insert(out.end(), p.factors.begin(), p.factors.end());
  return out;
}
}  // namespace

// ARITHMETIC. Where all hypotheses are true, m*D is a sum of zeros and of products >= 0, one of
// them > 0 for a strict goal, and m > 0 (for an equation: not 0). So D is 0, >= 0, > 0. That m*D is
// this sum is checked as an identity of polynomials, after multiplying by what is proved not 0.
Theorem arithmetic(Expr goal, const Certificate& c) {
  if (goal.op() != Op::Eq && goal.op() != Op::Lt && goal.op() != Op::Le)
    refuse("arithmetic proves =, < and <= only");
  const Polynomial d = polynomial(goal.arg(1)) - polynomial(goal.arg(0));
  const Polynomial left = multiplier(goal, c) * d - sum_of_equations(c) - sum_of_products(goal, c);
  const Polynomial rest = cleared(left, c.nonzero);
  if (!rest.empty())
    refuse("the certificate does not add up for " + brief(goal) +
           ", left over: " + brief(expression(rest)));
  const Theorems premises = premises_of(c);
  return Theorem(united(premises), goal, {"arithmetic", premises, {goal}, {}, c});
}

// INDUCTION. By induction on n - lo: the base is f at lo; the step holds for every n >= lo, because
// n is in no hypothesis and not in lo.
Theorem induction(Expr n, Expr lo, Expr f, const Theorem& base, const Theorem& step) {
  if (n.op() != Op::Var || n.sort() != Sort::Int || lo.sort() != Sort::Int)
    refuse("induction is over an integer variable, from an integer on");
  if (!is_term(lo) || free_variables(lo).count(n))
    refuse("the start of an induction depends on its variable");
  if (!is_formula(f)) refuse("induction proves a formula");
  check_not_in_hypotheses(n, base);
  check_not_in_hypotheses(n, step);
  const Expr first = substitute(f, {{n, lo}});
  if (!(canonical(base.conclusion()) == canonical(first)))
    refuse("the base says " + brief(base.conclusion()) + ", not " + brief(first));
  const Expr next = imp(logic_and({le(lo, n), f}), substitute(f, {{n, n + 1}}));
  if (!(canonical(step.conclusion()) == canonical(next)))
    refuse("the step says " + brief(step.conclusion()) + ", not " + brief(next));
  return Theorem(united({base, step}), imp(le(lo, n), f), {"induction", {base, step}, {n, lo, f}});
}
}  // namespace kernel
