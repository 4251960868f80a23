// SPDX-License-Identifier: GPL-2.0-or-later
// Steps of plain logic that chapters take again and again. Nothing here is trusted: the kernel
// makes every theorem.
#pragma once
#include <functional>
#include <string>

#include "kernel/theorem.hpp"

namespace algebra {
using namespace kernel;

/// `rule` with terms for its variables. What it then asks for, hypotheses that change and the
/// premise of an implication, is among `facts` or proved by `linear`.
Theorem at(const Theorem& rule, const Substitution& terms = {}, const Theorems& facts = {});
/// The same for an axiom, by its name.
Theorem at(const std::string& axiom_name, const Substitution& terms, const Theorems& facts = {});
/// f implies what `body` proves from f |- f.
Theorem given(Expr f, const std::function<Theorem(const Theorem&)>& body);
/// l = r implies `goal`, from `there`, which says it with r for l.
Theorem where_equal(Expr l, Expr r, Expr goal, const Theorem& there);
/// |- f if and only if g, from f |- g and g |- f.
Theorem equivalent(const Theorem& forth, const Theorem& back);
/// As `tautology`, where two terms that are compared are equal or one is less than the other.
Theorem follows(Expr goal, const Theorems& from);
/// Both sides of what is proved: of an equation, inequality, implication or equivalence.
inline Expr left(const Theorem& t) { return t.conclusion().arg(0); }
inline Expr right(const Theorem& t) { return t.conclusion().arg(1); }
/// The i-th part of a conjunction, from 0.
Theorem part(const Theorem& conjunction, std::size_t i);
/// The conjunction of all.
Theorem both(const Theorems& theorems);
template <class T>
std::vector<T> operator+(std::vector<T> a, const std::vector<T>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
/// Conjunctions and equations of matrices in parts.
Theorems parts(const Theorems& theorems);
/// f |- f for each.
Theorems assumed(const Exprs& formulas);
/// What all tactics may use, besides what they are given.
struct AllKnown {
  Theorems for_good, here;
};
void know_for_good(const Theorem& fact);
void know(const Theorem& fact);
/// Knows the assumptions, and forgets what `know` said.
void suppose(const Exprs& assumptions);
Theorems known();
/// What is known from now on is known until `Known` ends.
class Known {
public:
  explicit Known(const Theorems& facts = {});
  ~Known();
  Known(const Known&) = delete;
  Known& operator=(const Known&) = delete;

private:
  AllKnown before;
};
/// What f says, conjunct by conjunct.
Exprs conjuncts(Expr f);
bool is_among(Expr f, const Exprs& formulas);
/// Is f an equation or inequality?
inline bool is_relation(Expr f) { return f.op() == Op::Eq || f.op() == Op::Lt || f.op() == Op::Le; }
/// |- not 0 < 0
Theorem never();
/// f, H |- 0 < 0 gives H |- not f
Theorem refute(Expr f, const Theorem& absurd);
/// 0 <= n |- f by induction, from f at 0 and from a proof of f at n + 1 that may use f; 0 <= n is
/// known in it.
Theorem by_induction(Expr n, Expr f, const Theorem& base,
                     const std::function<Theorem(const Theorem&)>& step);
/// The same where `equation` shows f at 0 from `start` and at n + 1 from `next` and f.
Theorem by_induction(Expr n, Expr f, const Theorems& start, const Theorems& next,
                     const Exprs& bases = {});
/// l < r or l <= r, as facts that assume the contrary contradict each other by `linear`.
Theorem otherwise(Expr goal, const Theorems& facts);
/// The same conclusion under more hypotheses, so that a chapter shows what it means by a name.
Theorem under(const Exprs& hypotheses, const Theorem& theorem);
/// H, f |- c gives H, K |- c where `proof` is K |- f.
Theorem cut(const Theorem& proof, const Theorem& theorem);
/// i < j for integers as i + 1 <= j.
Theorem next_integer(const Theorem& less);
}  // namespace algebra
