// SPDX-License-Identifier: GPL-2.0-or-later
// Arithmetic by certificate. The kernel multiplies by what is not 0 to clear inverses; here each
// inverse w of d is a variable with w d - 1 = 0, and cofactors of these equations are found, so
// that the certificate is one identity of polynomials.
#include <algorithm>

#include "coq/script.hpp"
#include "kernel/polynomial.hpp"

namespace coq {
using kernel::Certificate;
using kernel::Expr;
using kernel::Exprs;
using kernel::Monomial;
using kernel::Op;
using kernel::Polynomial;
using kernel::Theorem;

namespace {
enum class Sign { zero, nonnegative, positive };
/// A term of the sum, and a proof of its sign.
struct Summand {
  std::string words;
  std::string proof;
  Sign sign;
};

Exprs sides(const Theorem& t) {
  const Expr f = t.conclusion();
  return f.op() == Op::Not ? f.arg(0).args() : f.args();
}
Polynomial gap(const Exprs& sides) {
  return kernel::polynomial(sides[1]) - kernel::polynomial(sides[0]);
}
Polynomial one() { return {{{}, 1}}; }
int degree(const Monomial& m, Expr atom) {
  for (const auto& [a, k] : m)
    if (a == atom) return k;
  return 0;
}
Polynomial power_of(Expr atom, int k) { return k == 0 ? one() : Polynomial{{{{atom, k}}, 1}}; }
/// The coefficient of the atom's k-th power.
Polynomial coefficient(const Polynomial& e, Expr atom, int k) {
  Polynomial out;
  for (const auto& [m, q] : e) {
    if (degree(m, atom) != k) continue;
    Monomial rest;
    for (const auto& factor : m)
      if (!(factor.first == atom)) rest.push_back(factor);
    out = out + Polynomial{{rest, q}};
  }
  return out;
}

/// What is left of the identity, as cofactors of w d - 1 for inverses w of d.
using Cofactors = std::vector<std::pair<Expr, Polynomial>>;
Cofactors cofactors(Polynomial e, const std::set<Expr>& divisors) {
  Cofactors out;
  Polynomial before = one();
  while (true) {
    Expr w;
    int k = 0;
    for (const auto& [m, q] : e)
      for (const auto& [a, exponent] : m)
        if (a.op() == Op::Fun && a.name() == "inv" && divisors.count(a.arg(0)) && (!w || w < a))
          w = a;
    if (!w) return out;
    for (const auto& [m, q] : e) k = std::max(k, degree(m, w));
    // e = (w d - 1) (sum of quotient_j w^j) + rest w^k
    const Polynomial d = kernel::polynomial(w.arg(0));
    Polynomial quotient;
    Polynomial all;
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
  const Certificate certificate = *t.step().certificate;
  Abstraction a;
  std::map<Expr, std::string> known;  // premises by their conclusions
  std::string premises;
  std::string proofs;
  std::string intros;
  kernel::Theorems used;
  const auto use = [&](const Theorem& p) {
    if (known.emplace(p.conclusion(), "p'" + std::to_string(known.size())).second)
      used.push_back(p);
    for (Expr side : sides(p)) a.add_atoms_of(side);
  };
  const auto printed_gap = [&](const Theorem& p) {
    return "(" + a.replaced(sides(p)[1]) + " - " + a.replaced(sides(p)[0]) + ")";
  };
  const auto form = [&](const Polynomial& p) { return kernel::expression(p); };

  // What is said, and which inverses are to be cleared.
  for (Expr side : goal.args()) a.add_atoms_of(side);
  Polynomial left = gap(goal.args());
  std::map<Expr, std::pair<Theorem, bool>> divisors;  // by canonical term; true: with a minus sign
  for (const Theorem& p : certificate.multipliers) {
    use(p);
    left = left * gap(sides(p));
  }
  for (const auto& [f, p] : certificate.equations) {
    use(p);
    a.add_atoms_of(kernel::canonical(f));
    left = left - kernel::polynomial(f) * gap(sides(p));
  }
  for (const auto& product : certificate.products) {
    Polynomial value = kernel::scaled(one(), product.coefficient);
    for (const Theorem& p : product.factors) {
      use(p);
      value = value * gap(sides(p));
    }
    for (Expr root : product.roots) {
      a.add_atoms_of(kernel::canonical(root));
      value = value * kernel::polynomial(root) * kernel::polynomial(root);
    }
    left = left - value;
  }
  std::set<Expr> allowed;
  for (const Theorem& p : certificate.nonzero) {
    const Polynomial d = gap(sides(p));
    divisors.emplace(form(d), std::pair{p, false});
    divisors.emplace(form(kernel::scaled(d, -1)), std::pair{p, true});
  }
  for (const auto& [d, p] : divisors) allowed.insert(d);
  const Cofactors rest = cofactors(left, allowed);
  for (const auto& [w, f] : rest) {
    use(divisors.at(w.arg(0)).first);
    a.add(w);
    a.add_atoms_of(w.arg(0));
    a.add_atoms_of(form(f));
  }

  // The sum.
  std::vector<Summand> sum;
  const auto is_strict = [](const Theorem& p) { return p.conclusion().op() == Op::Lt; };
  for (const auto& [f, p] : certificate.equations)
    sum.push_back({a.replaced(kernel::canonical(f)) + " * " + printed_gap(p),
                   "(zero_equation _ _ _ " + known.at(p.conclusion()) + ")", Sign::zero});
  for (const auto& product : certificate.products) {
    if (product.coefficient == 0) continue;
    const bool strict = product.roots.empty() &&
                        std::all_of(product.factors.begin(), product.factors.end(), is_strict);
    std::string words = text(Expr(product.coefficient));
    std::string proof =
        strict ? "(ltac:(lra) : 0 < " + words + ")" : "(ltac:(lra) : 0 <= " + words + ")";
    proof = "(" + proof + ")";
    const auto times = [&](const std::string& factor, const std::string& why) {
      words = "(" + words + " * " + factor + ")";
      proof = std::string(strict ? "(Rmult_lt_0_compat _ _ " : "(Rmult_le_pos _ _ ") + proof + " " +
              why + ")";
    };
    for (const Theorem& p : product.factors) {
      const std::string positive = "(gap_pos _ _ " + known.at(p.conclusion()) + ")";
      const std::string nonnegative = "(gap_nonneg _ _ " + known.at(p.conclusion()) + ")";
      times(printed_gap(p), strict         ? positive
                            : is_strict(p) ? "(Rlt_le _ _ " + positive + ")"
                                           : nonnegative);
    }
    for (Expr root : product.roots) {
      const std::string words_of_root = a.replaced(kernel::canonical(root));
      times("(" + words_of_root + " * " + words_of_root + ")", "(square _)");
    }
    sum.push_back({words, proof, strict ? Sign::positive : Sign::nonnegative});
  }
  std::string inverses;
  std::string nonzero;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    const auto& [w, f] = rest[k];
    const auto& [p, is_opposite] = divisors.at(w.arg(0));
    const std::string i = std::to_string(k);
    const std::string d = a.replaced(w.arg(0));
    const std::string variable = a.replaced(w);
    inverses += variable + " = / " + d + " -> ";
    const std::string fact = known.at(p.conclusion());
    nonzero +=
        "assert (n'" + i + " : " + d + " <> 0) by (apply (" +
        (is_opposite ? "opp_nonzero " : "same_nonzero ") + printed_gap(p) + "); [lra|exact (" +
        (is_strict(p) ? "pos_nonzero _ (gap_pos _ _ " + fact + ")" : "gap_nonzero _ _ " + fact) +
        ")]). ";
    sum.push_back({a.replaced(form(f)) + " * (" + variable + " * " + d + " - 1)",
                   "(zero_inverse _ _ _ w'" + i + " n'" + i + ")", Sign::zero});
    intros += " w'" + i;
    proofs += " eq_refl";
  }
  for (const Theorem& p : used) {
    premises += a.print(p.conclusion()) + " -> ";
    intros += " " + known.at(p.conclusion());
    proofs += " " + applied(p, c);
  }
  std::string words = "0";
  std::string proof = "eq_refl";
  Sign sign = Sign::zero;
  for (const Summand& s : sum) {
    if (&s == &sum.front()) {
      words = s.words;
      proof = s.proof;
      sign = s.sign;
      continue;
    }
    const auto at_least = [](const std::string& why, Sign of) {
      return of == Sign::zero ? "(zero_nonneg _ " + why + ")" : why;
    };
    static const std::map<std::pair<bool, bool>, std::string> sums = {
        {{false, false}, "Rplus_le_le_0_compat"},
        {{false, true}, "Rplus_le_lt_0_compat"},
        {{true, false}, "Rplus_lt_le_0_compat"},
        {{true, true}, "Rplus_lt_0_compat"}};
    words = "(" + words + " + " + s.words + ")";
    const bool are_zero = sign == Sign::zero && s.sign == Sign::zero;
    const std::string rule =
        are_zero ? "zero_sum" : sums.at({sign == Sign::positive, s.sign == Sign::positive});
    proof = are_zero ? "(zero_sum _ _ " + proof + " " + s.proof + ")"
                     : "(" + rule + " _ _ " + at_least(proof, sign) + " " +
                           at_least(s.proof, s.sign) + ")";
    sign = std::max({sign, s.sign});
  }
  // The multiplier.
  std::string multiplier = "1";
  const bool is_equation = goal.op() == Op::Eq;
  std::string why = is_equation ? "R1_neq_R0" : "Rlt_0_1";
  for (const Theorem& p : certificate.multipliers) {
    const std::string fact = known.at(p.conclusion());
    std::string factor =
        is_strict(p) ? "(gap_pos _ _ " + fact + ")" : "(gap_nonzero _ _ " + fact + ")";
    if (is_equation && is_strict(p)) factor = "(pos_nonzero _ " + factor + ")";
    multiplier = "(" + multiplier + " * " + printed_gap(p) + ")";
    why = std::string(is_equation ? "(Rmult_integral_contrapositive_currified _ _ "
                                  : "(Rmult_lt_0_compat _ _ ") +
          why + " " + factor + ")";
  }
  if (goal.op() == Op::Le && sign != Sign::nonnegative)
    proof = sign == Sign::zero ? "(zero_nonneg _ " + proof + ")" : "(Rlt_le _ _ " + proof + ")";
  const std::string rule = is_equation ? "by_eq" : goal.op() == Op::Lt ? "by_lt" : "by_le";
  const Core all = core(a, {});
  const std::string l = a.replaced(goal.arg(0));
  const std::string r = a.replaced(goal.arg(1));
  const std::string identity = multiplier + " * (" + r + " - " + l + ") = " + words;
  return "assert (core : " + all.statement + inverses + premises + a.print(goal) +
         "). { clear. intros" + all.intros + intros + ". " + nonzero + "apply (" + rule + " _ _ " +
         multiplier + " (" + words + ")); [clear; " + "lra" + "|exact " + why + "|exact " + proof +
         "]. } exact (core" + all.arguments + proofs + ").";
}
}  // namespace coq
