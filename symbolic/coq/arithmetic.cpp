// Arithmetic by certificate. The kernel multiplies by what is not 0 to clear inverses; here each
// inverse w of d is a variable with w d - 1 = 0, and cofactors of these equations are found, so
// that the certificate is one identity of polynomials.
#include <algorithm>

#include "coq/script.hpp"
#include "kernel/polynomial.hpp"

namespace coq {
using kernel::one, kernel::Polynomial;

namespace {
Exprs sides(const Theorem& t) {
  const Expr f = t.conclusion();
  return f.op() == Op::Not ? f.arg(0).args() : f.args();
}
Polynomial gap(const Exprs& sides) {
  return kernel::polynomial(sides[1]) - kernel::polynomial(sides[0]);
}
Polynomial power_of(Expr atom, int k) { return k == 0 ? one() : Polynomial{{{{atom, k}}, 1}}; }
/// The coefficient of the atom's k-th power.
Polynomial coefficient(const Polynomial& e, Expr atom, int k) {
  Polynomial out;
  for (const auto& [m, q] : e) {
    if (degree(m, atom) != k) continue;
    kernel::Monomial rest = m;
    std::erase_if(rest, [&](const auto& factor) { return factor.first == atom; });
    out = out + Polynomial{{rest, q}};
  }
  return out;
}

/// What is left of the identity, as cofactors of w d - 1 for inverses w of d.
using Cofactors = std::vector<std::pair<Expr, Polynomial>>;
Cofactors cofactors(Polynomial e, const std::map<Expr, Theorem>& divisors) {
  Cofactors out;
  Polynomial before = one();
  while (true) {
    const Expr w = kernel::youngest_inverse(e, [&](Expr d) { return divisors.contains(d); });
    if (!w) return out;
    int k = 0;
    for (const auto& [m, q] : e) k = std::max(k, degree(m, w));
    // e = (w d - 1) (sum of quotient_j w^j) + rest w^k
    const Polynomial d = kernel::polynomial(w.arg(0));
    Polynomial quotient, all;
    for (int j = 0; j < k; ++j) {
      quotient = d * quotient - coefficient(e, w, j);
      all = all + quotient * power_of(w, j);
    }
    out.emplace_back(w, before * all);
    before = before * power_of(w, k);
    e = coefficient(e, w, k) - d * quotient;
  }
}
}  // namespace

std::string Script::arithmetic(const Theorem& t, const Context& c) {
  const Expr goal = t.conclusion();
  const kernel::Certificate certificate = *t.step().certificate;
  Abstraction a;
  std::map<Expr, Theorem> used;  // premises by their conclusions
  const auto use = [&](const Theorem& p) {
    used.emplace(p.conclusion(), p);
    for (Expr side : sides(p)) a.add_atoms_of(side);
    return gap(sides(p));
  };

  // What is left of the identity, without what is not 0; and which of this it needs.
  for (Expr side : goal.args()) a.add_atoms_of(side);
  Polynomial left = gap(goal.args());
  for (const Theorem& p : certificate.multipliers) left = left * use(p);
  for (const auto& [f, p] : certificate.equations) left = left - kernel::polynomial(f) * use(p);
  for (const auto& product : certificate.products) {
    Polynomial all = kernel::scaled(one(), product.coefficient);
    for (const Theorem& p : product.factors) all = all * use(p);
    for (Expr root : product.roots) all = all * kernel::polynomial(root * root);
    left = left - all;
  }
  std::map<Expr, Theorem> divisors;  // by canonical term, with both signs
  for (const Theorem& p : certificate.nonzero)
    for (const int signs : {1, -1})
      divisors.emplace(kernel::expression(kernel::scaled(gap(sides(p)), signs)), p);
  const Cofactors rest = cofactors(left, divisors);
  for (const auto& [w, f] : rest) use(divisors.at(w.arg(0)));

  // The sum, and the multiplier.
  const auto words = [&](Expr term) {
    const Expr form = kernel::canonical(term);
    a.add_atoms_of(form);
    return a.replaced(form);
  };
  const auto gap_of = [&](const Theorem& p) {
    return " * (" + a.replaced(sides(p)[1]) + " - " + a.replaced(sides(p)[0]) + ")";
  };
  std::string sum;
  const auto add = [&sum](const std::string& term) {
    sum = sum.empty() ? term : "(" + sum + " + " + term + ")";
  };
  for (const auto& [f, p] : certificate.equations) add(words(f) + gap_of(p));
  for (const auto& product : certificate.products) {
    if (product.coefficient == 0) continue;
    std::string term = words(Expr(product.coefficient));
    for (const Theorem& p : product.factors) term = "(" + term + gap_of(p) + ")";
    for (Expr root : product.roots)
      term = "(" + term + " * (" + words(root) + " * " + words(root) + "))";
    add(term);
  }
  std::string statement, proofs, nonzero;
  for (const auto& [w, f] : rest) {
    add(words(kernel::expression(f)) + " * (" + words(w) + " * " + words(w.arg(0)) + " - 1)");
    statement += words(w) + " = / " + words(w.arg(0)) + " -> ";
    proofs += " eq_refl";
    nonzero += "assert (n'" + std::to_string(nonzero.size()) + " : " + words(w.arg(0)) +
               " <> 0) by divisor (1" + gap_of(divisors.at(w.arg(0))) + "). ";
  }
  for (const auto& [f, p] : used) {
    statement += a.print(f) + " -> ";
    proofs += " " + applied(p, c);
  }
  std::string multiplier = "1";
  for (const Theorem& p : certificate.multipliers) multiplier = "(" + multiplier + gap_of(p) + ")";
  const Core all = core(a, {});
  const std::string rule = goal.op() == Op::Eq ? "by_eq" : goal.op() == Op::Lt ? "by_lt" : "by_le";
  return "assert (c'0 : " + all.statement + statement + a.print(goal) + "). { clear. intros" +
         all.intros + ". intros. " + nonzero + "apply (" + rule + " _ _ " + multiplier + " (" +
         (sum.empty() ? "0" : sum) + ")); [number|sign|sign]. } exact (c'0" + all.arguments +
         proofs + ").";
}
}  // namespace coq
