// That two terms are equal as polynomials, two formulas the same up to that: each term is proved
// equal to its canonical form, once, from what its atoms are equal to.
#include <algorithm>
#include <numeric>

#include "coq/script.hpp"
#include "kernel/polynomial.hpp"

namespace coq {
using kernel::one, kernel::Polynomial;

namespace {
bool is_sum_or_product(Expr e) {
  return e.op() == Op::Num || e.op() == Op::Add || e.op() == Op::Mul || e.op() == Op::Pow;
}
bool is_number(Expr e) {
  return kernel::is_call(e, "inv") && e.arg(0).op() == Op::Num && e.arg(0).value() != 0;
}
/// As the prelude's det computes it.
Expr laplace(Expr a, int row, const std::vector<int>& columns) {
  if (columns.empty()) return 1;
  Expr out;
  for (std::size_t k = columns.size(); k-- > 0;) {
    std::vector<int> rest = columns;
    rest.erase(rest.begin() + std::ptrdiff_t(k));
    Expr minor = kernel::product({kernel::entry(a, row, columns[k]), laplace(a, row + 1, rest)});
    if (k % 2 == 1) minor = kernel::product({-1, minor});
    out = out ? kernel::sum({minor, out}) : minor;
  }
  return out;
}
Expr laplace(Expr a) {
  std::vector<int> columns(std::size_t(a.cols()));
  std::iota(columns.begin(), columns.end(), 0);
  return laplace(a, 0, columns);
}

// Arithmetic by certificate. The kernel multiplies by what is not 0 to clear inverses; here each
// inverse w of d is a variable with w d - 1 = 0, and cofactors of these equations are found, so
// that the certificate is one identity of polynomials.

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

void Abstraction::add(Expr e) {
  if (names.count(e)) return;
  const Expr form = kernel::canonical(e);
  names[e] = (form == e ? "x'" : "y'") + std::to_string(atoms.size());
  atoms.push_back(e);
  if (!(form == e)) add_atoms_of(form);
  inside[e] = print(form);
}
void Abstraction::add_atoms_of(Expr term) {
  if (is_number(term)) return;
  if (!is_sum_or_product(term)) return add(term);
  for (Expr a : term.args()) add_atoms_of(a);
}

Script::Core Script::core(const Abstraction& a, const Names& bound) {
  Core out;
  std::string premises, arrows, proofs;
  for (Expr e : a.atoms) {
    out.intros += " " + a.print(e);
    out.arguments += " " + gallina(e, bound);
    const Expr form = kernel::canonical(e);
    if (form == e) continue;
    premises += a.print(e) + " = " + a.print(form) + " -> ";
    arrows += " ->";
    proofs += " " + to_canonical(e, bound);
  }
  if (!out.intros.empty()) out.statement = "forall" + out.intros + " : R, " + premises;
  out.intros += arrows;
  out.arguments += proofs;
  return out;
}

std::string Script::equal(Expr l, Expr r, const Names& bound) {
  if (l == r) return "eq_refl";
  return "(eq_trans " + to_canonical(l, bound) + " (eq_sym " + to_canonical(r, bound) + "))";
}
std::string Script::shared(const std::string& kind, Expr e, const Names& bound,
                           const std::function<std::string(const Names&)>& statement,
                           const std::function<std::string()>& proof) {
  const Names own = loose_names(e);
  Names variables = names_of(variables_of({e}));
  std::string& known = shared_lemmas[{kind, e}];
  if (known.empty()) {
    define_all(e);
    const std::string binders = spaced(variables) + spaced(own);
    known = add_lemma(kind, (binders.empty() ? "" : "forall" + binders + " : R, ") + statement(own),
                      "intros" + binders + ". " + proof());
  }
  variables.insert(variables.end(), bound.end() - std::ptrdiff_t(own.size()), bound.end());
  return "(" + known + spaced(variables) + ")";
}
std::string Script::to_canonical(Expr e, const Names& bound) {
  const Expr form = kernel::canonical(e);
  if (form == e) return "eq_refl";
  return shared(
      "e'", e, bound,
      [&](const Names& own) { return gallina(e, own) + " = " + gallina(form, own); },
      [&] { return prove_canonical(e); });
}
std::string Script::prove_canonical(Expr e) {
  const Expr form = kernel::canonical(e);
  const Names own = loose_names(e);
  if (e.op() == Op::Det || e.op() == Op::Times || e.op() == Op::Transpose) {
    const Expr computed =
        e.op() == Op::Det ? laplace(e.arg(0)) : kernel::matrix(e.cols(), kernel::entries(e));
    return "change (" + gallina(computed, own) + " = " + gallina(form, own) + "). exact " +
           to_canonical(computed, own) + ".";
  }
  if (!is_sum_or_product(e) && !is_number(e)) {
    Exprs args;
    std::string congruence = "repeat first [reflexivity";  // equal arguments of one function
    for (Expr part : e.args()) {
      args.push_back(kernel::canonical(part));
      if (!(args.back() == part)) congruence += "|exact " + to_canonical(part, own);
    }
    congruence += "|f_equal]";
    const Expr applied = kernel::with_args(e, args);
    if (applied == form) return congruence + ".";
    return "transitivity " + gallina(applied, own) + "; [" + congruence + "|exact " +
           to_canonical(applied, own) + "].";  // inv(1 + 1)
  }
  Abstraction a;
  a.add_atoms_of(e);
  a.add_atoms_of(form);
  const Core c = core(a, own);
  return "assert (c'0 : " + c.statement + a.print(e) + " = " + a.print(form) +
         "). { clear. intros" + c.intros + ". lra. } exact (c'0" + c.arguments + ").";
}

bool is_matrix_equation(Expr f) { return f.op() == Op::Eq && f.arg(0).sort() == Sort::Matrix; }
Expr by_entries(Expr equation) { return kernel::logic_and(kernel::entry_equations(equation)); }
std::string Script::same_entries(Expr f, const Names& bound) {
  return shared(
      "m'", f, bound,
      [&](const Names& own) { return gallina(f, own) + " <-> " + gallina(by_entries(f), own); },
      [&] { return "entrywise " + std::to_string(kernel::entries(f.arg(0)).size()) + "%nat."; });
}

std::string Script::same(Expr f, Expr g, const Names& bound) {
  if (f == g) return "(iff_refl _)";
  if (is_matrix_equation(f))
    return "(iff_trans " + same_entries(f, bound) + " " + same(by_entries(f), g, bound) + ")";
  if (is_matrix_equation(g))
    return "(iff_trans " + same(f, by_entries(g), bound) + " (iff_sym " + same_entries(g, bound) +
           "))";
  static const std::map<Op, std::string> lemmas_of = {
      {Op::Eq, "same_eq R"}, {Op::Lt, "same_lt"},   {Op::Le, "same_le"},  {Op::And, "same_and"},
      {Op::Or, "same_or"},   {Op::Imp, "same_imp"}, {Op::Iff, "same_iff"}};
  if (f.op() == Op::Fun) return "(same_prop _ _ " + equal(f, g, bound) + ")";
  if (f.op() == Op::Not) return "(same_not _ _ " + same(f.arg(0), g.arg(0), bound) + ")";
  if (f.op() == Op::All) {
    const std::string v = "q'" + std::to_string(bound.size());
    Names inner = bound;
    inner.push_back(v);
    const bool is_integer = f.bound_sort() == Sort::Int;
    std::string predicates;
    for (Expr h : {f, g})
      predicates += "(fun " + v + " => " + (is_integer ? "isint " + v + " -> " : "") +
                    gallina(h.arg(0), inner) + ") ";
    const std::string proof = same(f.arg(0), g.arg(0), inner);
    return "(same_all " + predicates + "(fun " + v + " => " +
           (is_integer ? "same_imp _ _ _ _ (iff_refl _) " : "") + proof + "))";
  }
  const bool is_relation = f.op() == Op::Eq || f.op() == Op::Lt || f.op() == Op::Le;
  const auto part = [&](std::size_t k) {
    return is_relation ? equal(f.arg(k), g.arg(k), bound) : same(f.arg(k), g.arg(k), bound);
  };
  std::string out = part(f.size() - 1);
  for (std::size_t k = f.size() - 1; k-- > 0;)
    out = "(" + lemmas_of.at(f.op()) + " _ _ _ _ " + part(k) + " " + out + ")";
  return out;
}

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
