// SPDX-License-Identifier: GPL-2.0-or-later
// That two terms are equal as polynomials, two formulas the same up to that: each term is proved
// equal to its canonical form, once, from what its atoms are equal to.
#include <algorithm>
#include <numeric>

#include "coq/script.hpp"
#include "kernel/polynomial.hpp"

namespace coq {
using kernel::Expr;
using kernel::Exprs;
using kernel::Op;
using kernel::Sort;

namespace {
bool is_matrix_equation(Expr f) { return f.op() == Op::Eq && f.arg(0).sort() == Sort::Matrix; }
bool is_sum_or_product(Expr e) {
  return e.op() == Op::Num || e.op() == Op::Add || e.op() == Op::Mul || e.op() == Op::Pow;
}
bool is_number(Expr e) {
  return e.op() == Op::Fun && e.name() == "inv" && e.arg(0).op() == Op::Num &&
         e.arg(0).value() != 0;
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
std::string type_of(Expr e) { return e.sort() == Sort::Matrix ? "list R" : "R"; }
}  // namespace

void Abstraction::add(Expr e) {
  if (names.count(e)) return;
  const Expr form = kernel::canonical(e);
  const bool is_canonical = form == e;
  Exprs& list = is_canonical ? canonical : equal;
  names[e] = (is_canonical ? "x'" : "y'") + std::to_string(list.size());
  list.push_back(e);
  if (!is_canonical) add_atoms_of(form);
  inside[e] = is_canonical ? names[e] : print(form);
}
void Abstraction::add_atoms_of(Expr term) {
  if (is_number(term)) return;
  if (!is_sum_or_product(term)) return add(term);
  for (Expr a : term.args()) add_atoms_of(a);
}

Script::Core Script::core(const Abstraction& a, const Names& bound) {
  Core out;
  std::string premises;
  std::string proofs;
  std::string arrows;
  for (const Exprs* list : {&a.canonical, &a.equal}) {
    for (Expr e : *list) {
      const std::string& variable = a.names.at(e);
      out.statement += " (" + variable + " : " + type_of(e) + ")";
      out.intros += " " + variable;
      out.arguments += " " + text(e, bound);
      if (list == &a.canonical) continue;
      premises += variable + " = " + a.print(kernel::canonical(e)) + " -> ";
      arrows += " ->";
      proofs += " " + to_canonical(e, bound);
    }
  }
  if (!out.statement.empty()) out.statement = "forall" + out.statement + ", ";
  out.statement += premises;
  out.intros += arrows;
  out.arguments += proofs;
  return out;
}

std::string Script::equal(Expr l, Expr r, const Names& bound) {
  if (l == r) return "eq_refl";
  return "(eq_trans " + to_canonical(l, bound) + " (eq_sym " + to_canonical(r, bound) + "))";
}
std::string Script::to_canonical(Expr e, const Names& bound) {
  const Expr form = kernel::canonical(e);
  if (form == e) return "eq_refl";
  const auto known = equalities.find(e);
  const Names own = loose_names(e);
  Names variables = names_of(variables_of({e}));
  if (known == equalities.end()) {
    define_all(e);
    const std::string proof = prove_canonical(e);
    const std::string binders = spaced(variables) + spaced(own);
    const std::string all = binders.empty() ? "" : "forall" + binders + " : R, ";
    equalities[e] = add_lemma("e'", all + text(e, own) + " = " + text(form, own),
                              (binders.empty() ? "" : "intros" + binders + ". ") + proof);
  }
  variables.insert(variables.end(), bound.end() - std::ptrdiff_t(own.size()), bound.end());
  return "(" + equalities.at(e) + spaced(variables) + ")";
}
std::string Script::prove_canonical(Expr e) {
  const Expr form = kernel::canonical(e);
  const Names own = loose_names(e);
  const bool is_computed_matrix =
      e.op() == Op::Matrix || e.op() == Op::Times || e.op() == Op::Transpose;
  if (e.op() == Op::Det || (is_computed_matrix && e.op() != Op::Matrix)) {
    const Expr computed =
        e.op() == Op::Det ? laplace(e.arg(0)) : kernel::matrix(e.cols(), kernel::entries(e));
    return "change (" + text(computed, own) + " = " + text(form, own) + "). exact " +
           to_canonical(computed, own) + ".";
  }
  if (!is_sum_or_product(e) && !is_number(e)) {
    Exprs args;
    for (Expr part : e.args()) args.push_back(kernel::canonical(part));
    const std::string folded = to_canonical(kernel::with_args(e, args), own);  // inv(1 + 1)
    return "exact " +
           (folded == "eq_refl" ? congruence(e)
                                : "(eq_trans " + congruence(e) + " " + folded + ")") +
           ".";
  }
  Abstraction a;
  a.add_atoms_of(e);
  a.add_atoms_of(form);
  const Core c = core(a, own);
  const std::string equation = a.print(e) + " = " + a.print(form);
  return "assert (core : " + c.statement + equation + "). { clear. intros" + c.intros + ". " +
         "lra" + ". } exact (core" + c.arguments + ").";
}

/// One argument after the other, each by its own equation.
std::string Script::congruence(Expr e) {
  const Names own = loose_names(e);
  Atoms now;
  for (Expr a : e.args()) now[a] = text(a, own);
  std::string out = "eq_refl";
  for (const auto& [a, words] : Atoms(now)) {
    const Expr form = kernel::canonical(a);
    if (form == a) continue;
    now[a] = "z'";
    const std::string step =
        "(f_equal (fun z' => " + text(e, own, now) + ") " + to_canonical(a, own) + ")";
    now[a] = text(form, own);
    out = out == "eq_refl" ? step : "(eq_trans " + out + " " + step + ")";
  }
  return out;
}

Expr by_entries(Expr equation) {
  const Exprs l = kernel::entries(equation.arg(0));
  const Exprs r = kernel::entries(equation.arg(1));
  Exprs out;
  for (std::size_t k = 0; k < l.size(); ++k) out.push_back(kernel::eq(l[k], r[k]));
  return kernel::logic_and(out);
}
std::string Script::same_entries(Expr f, const Names& bound) {
  const Names own = loose_names(f);
  Names variables = names_of(variables_of({f}));
  if (!entrywise.count(f)) {
    define_all(f);
    const std::string binders = spaced(variables) + spaced(own);
    const std::size_t count = kernel::entries(f.arg(0)).size();
    std::string there = "_";
    std::string cases;
    std::string pattern;
    std::string back = "eq_refl";
    for (std::size_t k = count; k-- > 0;) {
      const std::string e = "E" + std::to_string(k);
      pattern = pattern.empty() ? e : "[" + e + " " + pattern + "]";
      if (k > 0) there = "(conj _ " + there + ")";
      cases = "exact (f_equal (fun z' => entry z' " + std::to_string(k) + ") H)" +
              (cases.empty() ? "" : " | ") + cases;
      back = "(same_cons _ _ _ _ " + e + " " + back + ")";
    }
    std::string proof = (binders.empty() ? "" : "intros" + binders + ". ") +
                        "split. { intro H. refine " + there + "; [" + cases + "]. } intros " +
                        pattern + ". ";
    for (Expr side : f.args()) {
      std::string entries;
      for (Expr x : kernel::entries(side)) entries += (entries.empty() ? "" : "; ") + text(x, own);
      proof += "assert (" + std::string(side == f.arg(0) ? "L" : "K") + " : " + text(side, own) +
               " = [" + entries + "]) by matrix_entries. ";
    }
    proof += "exact (eq_trans L (eq_trans " + back + " (eq_sym K))).";
    entrywise[f] = add_lemma("m'",
                             (binders.empty() ? "" : "forall" + binders + " : R, ") + text(f, own) +
                                 " <-> " + text(by_entries(f), own),
                             proof);
  }
  variables.insert(variables.end(), bound.end() - std::ptrdiff_t(own.size()), bound.end());
  return "(" + entrywise.at(f) + spaced(variables) + ")";
}

std::string Script::same(Expr f, Expr g, const Names& bound) {
  if (f == g) return "(iff_refl _)";
  if (is_matrix_equation(f))
    return "(iff_trans " + same_entries(f, bound) + " " + same(by_entries(f), g, bound) + ")";
  if (is_matrix_equation(g))
    return "(iff_trans " + same(f, by_entries(g), bound) + " (iff_sym " + same_entries(g, bound) +
           "))";
  return same_parts(f, g, bound);
}
std::string Script::same_parts(Expr f, Expr g, const Names& bound) {
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
                    text(h.arg(0), inner) + ") ";
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
}  // namespace coq
