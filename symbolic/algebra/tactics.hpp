// Tactics: each finds a proof that the kernel checks: nothing here is trusted. Refused: none found.
#pragma once

#include "kernel/polynomial.hpp"
#include "kernel/theorem.hpp"

namespace algebra {
using namespace kernel;

// Steps of plain logic.
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
/// A conjunction or an equation of matrices by a proof of each part; nothing for other goals.
std::optional<Theorem> by_parts(Expr goal, const std::function<Theorem(Expr)>& prove);
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
/// 0 <= n |- f by induction, from f at 0 and a proof of f at n + 1 that may use f and 0 <= n.
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

// Equations of terms and of matrices: cofactors are found here and checked by the kernel.
/// The quotient of two monomials, if it is one.
std::optional<Monomial> divided(const Monomial& monomial, const Monomial& by);
/// q - p of p = q, p < q, p <= q or not p = q.
Expr gap(Expr relation);
inline Expr gap(const Theorem& relation) { return gap(relation.conclusion()); }
/// `goal` (l = r of terms or of matrices, or several): each equation of `facts` (monomial = term)
/// rewrites a monomial; denominators are cleared that `facts` (0 < d, not d = 0) or `positive` say
/// not to be 0; squares of roots are rewritten; sines and cosines are expanded in those of the
/// angles `bases`, if any. Throws Refused, with what is left over, if that does not end in 0 = 0.
Theorem equation(Expr goal, const Theorems& facts = {}, const Exprs& bases = {});
Theorem equation(Expr l, Expr r, const Theorems& facts = {}, const Exprs& bases = {});
/// The same after the goal is multiplied by `factors`, each proved not 0; `rest` may prove that
/// what is left over is 0.
Theorem cancel(Expr goal, const Theorems& factors, const Theorems& facts = {},
               const Exprs& bases = {}, const std::function<Theorem(Expr)>& rest = {});
/// What the equations among `facts` leave of a term when no more can be rewritten.
Expr reduced(Expr term, Theorems facts);
/// `arithmetic`, where multipliers are divisors, too.
Theorem certified(Expr goal, Certificate c);
/// x = the rest of an equation in which the monomial x is a term.
Theorem solved_for(Expr x, const Theorem& equation);
/// l = m and m = r give l = r.
Theorem chain(const Theorem& a, const Theorem& b);
/// l = r gives r = l.
Theorem turned(const Theorem& e);
Theorems entries(const Theorem& matrix_equation);
/// |- sqrt(x)^2 = x from 0 <= x or 0 < x.
Theorem root_squared(const Theorem& not_negative);
/// l < r or l <= r from what `facts` say of l^n and r^n; where n is even, also 0 <= l and 0 <= r.
Theorem by_powers(Expr goal, int n, const Theorems& facts);
/// |- a = b from a^n = b^n; where n is even, also from `signs`: 0 <= a and 0 <= b.
Theorem same_root(const Theorem& powers, const Theorems& signs = {});
/// |- sqrt(x) = t from t^2 = x and 0 < t or 0 <= t.
Theorem root_of(const Theorem& square, const Theorem& t_sign);
/// The same where `equation` and `positive` show both.
Theorem root_is(Expr x, Expr t, const Theorems& facts = {});

// Inequalities by linear combination.
/// `goal` (=, also of matrices, <, <=, not =; several of them, or one that implies or is equivalent
/// to another) as a linear combination of `facts` (=, <, <=), each monomial an unknown; the
/// combination is found by Fourier's and Motzkin's elimination. Where they do not suffice: with
/// what is known, d/d = 1, squares of roots, the axioms of pi, ceilings and arctangents, i < j as
/// i + 1 <= j for integers, and the sign of the gap as `positive` sees it. Else throws Refused.
Theorem linear(Expr goal, const Theorems& facts = {});
/// `goal` from `relation`, which `linear` shows, times a positive factor.
Theorem scaled(Expr goal, Expr relation, Expr factor, const Theorems& facts = {});
/// An equivalence of two inequalities, of which the first is the second times a positive factor.
Theorem same_sign(Expr equivalence, Expr factor, const Theorems& facts);
/// An equation as a linear combination of equations and of nothing else, or nothing.
std::optional<Theorem> combination(Expr equation, const Theorems& equations);
/// As `linear` for one relation, but without the sign of the gap, or nothing.
std::optional<Theorem> linear_if(Expr goal, const Theorems& facts);

// Signs of terms from their shape.
/// |- 0 < l from l = r, where that shows 0 < r.
Theorem positive(const Theorem& is, const Theorems& facts = {});
/// |- 0 < t: numbers, sums, products, powers, quotients, roots, pi and arctangents of positive
/// terms, sines of angles below pi, cosines of those below pi/2; `facts`, what is known and
/// `linear` say the rest. Throws Refused where nothing shows it.
Theorem positive(Expr t, const Theorems& facts = {});
/// |- 0 <= t
Theorem not_negative(Expr t, const Theorems& facts = {});
/// |- 0 < t or |- 0 <= t, or nothing.
std::optional<Theorem> sign_of(Expr t, const Theorems& facts = {}, bool strict = true);
/// 0 < (q - p)(s - r)... from p < q, r < s, ..., 0 <= where one of them is <=.
Theorem product_of(const Theorems& factors);
Theorem times(const Theorem& a, const Theorem& b);
/// The same for a term that is `positive`.
Theorem times(const Theorem& a, Expr positive_term);

// Sines and cosines of integer combinations of angles.
/// Rules for `equation`: each sine and cosine in `terms` in those of `bases`, by the addition
/// theorems, if its angle is a combination of them with integer coefficients; where `circle` is
/// true, also sin^2 = 1 - cos^2 of each base.
Theorems angles(const Exprs& terms, const Exprs& bases, bool circle = true);
/// |- cos(pi/d) = ... and |- sin(pi/d) = ... in square roots, for 2^i, 3, 5 and 15 times that; the
/// signs: 0 < x for each root in them. Nothing for other d.
struct PartOfPi {
  Theorem cosine, sine;
  Theorems signs;
};
std::optional<PartOfPi> part_of_pi(int d);
/// p = q from cos(p) = cos(q), as the cosine falls from 0 to pi: `linear` finds p and q there.
Theorem same_angle(const Theorem& cosines, const Theorems& facts = {});
/// cos(q) < cos(p) from p < q, <= from p <= q: `linear` finds 0 <= p and q <= pi.
Theorem cosine_falls(const Theorem& less, const Theorems& facts = {});
/// 0 <= sin(t): `linear` finds 0 <= t and t <= pi.
Theorem sine_not_negative(Expr t, const Theorems& facts = {});

// GiNaC solves, multiplies out and factors. What it says is a proposal that the kernel certifies:
// a mistake is a proof that is not found. Its order of terms, new in each run, changes no result.
/// The unknowns from equations that are linear in them (after denominators are cleared), in the
/// order of `unknowns`, each as `simplified` with `collect`. Refused: none, or more than one.
Exprs solve(const Exprs& equations, const Exprs& unknowns, const Exprs& collect = {});
/// A quotient of products of powers, roots out of the denominator; sums are collected by the atoms
/// in `collect`. All but +, *, powers, quotients and square roots are atoms. Matrices by entries.
Expr simplified(Expr term, const Exprs& collect = {});
}  // namespace algebra
