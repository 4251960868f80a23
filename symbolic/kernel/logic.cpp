// The rules of logic. Above each stands why it is sound.

#include "kernel/polynomial.hpp"
#include "kernel/theorem.hpp"

namespace kernel {
// ASSUME. Where f is true, f is true.
Theorem assume(Expr f) { return Theorem({f}, f, {"assume", {}, {f}}); }

// DISCHARGE. Where H - {f} is true, f is false, and the implication true, or all of H is, and c is.
Theorem discharge(Expr f, const Theorem& t) {
  Exprs rest;
  for (Expr h : t.hypotheses())
    if (!(h == f)) rest.push_back(h);
  return Theorem(rest, imp(f, t.conclusion()), {"discharge", {t}, {f}});
}

// TAUTOLOGY. Every assignment of truth values that makes all premises true makes the goal true.
// Parts that are no connective are taken by their canonical form, which has the same truth value,
// l <= r as not r < l; so every real situation is one of the assignments, and all are tried.
namespace {
enum class Truth { False, True, Unknown };
using Assignment = std::map<Expr, bool>;

Truth truth_of(bool b) { return b ? Truth::True : Truth::False; }

class Cases {
public:
  Cases(Expr wanted, const Theorems& from) : goal(wanted) {
    for (const Theorem& t : from) premises.push_back(t.conclusion());
  }
  bool all_good() {
    if (++count > 20000) refuse("more than 20000 cases for " + brief(goal));
    undecided = Expr();
    bool all_true = true;
    for (Expr p : premises) {
      const Truth v = value(p);
      if (v == Truth::False) return true;
      if (v == Truth::Unknown) all_true = false;
    }
    const Truth v = value(goal);
    if (v == Truth::True) return true;
    if (all_true && v == Truth::False) return false;
    return both_good(undecided);
  }

private:
  bool both_good(Expr atom) {
    for (bool b : {true, false}) {
      assigned[atom] = b;
      const bool good = all_good();
      assigned.erase(atom);
      if (!good) return false;
    }
    return true;
  }
  Truth value(Expr f) {
    switch (f.op()) {
      case Op::Not:
        return opposite(value(f.arg(0)));
      case Op::And:
        return until(f, Truth::False, Truth::True);
      case Op::Or:
        return until(f, Truth::True, Truth::False);
      case Op::Imp:
        return implied(value(f.arg(0)), value(f.arg(1)));
      case Op::Iff:
        return alike(value(f.arg(0)), value(f.arg(1)));
      case Op::Le:
        return opposite(atom(lt(f.arg(1), f.arg(0))));
      default:
        return atom(f);
    }
  }
  static Truth opposite(Truth v) { return v == Truth::Unknown ? v : truth_of(v == Truth::False); }
  static Truth implied(Truth p, Truth q) {
    if (p == Truth::False || q == Truth::True) return Truth::True;
    return p == Truth::True ? q : Truth::Unknown;
  }
  static Truth alike(Truth p, Truth q) {
    if (p == Truth::Unknown || q == Truth::Unknown) return Truth::Unknown;
    return truth_of(p == q);
  }
  // One part with the value `stop` decides; `otherwise` if no part is unknown.
  Truth until(Expr f, Truth stop, Truth otherwise) {
    Truth out = otherwise;
    for (Expr a : f.args()) {
      const Truth v = value(a);
      if (v == stop) return stop;
      if (v == Truth::Unknown) out = v;
    }
    return out;
  }
  Truth atom(Expr f) {
    const Expr form = canonical(f);
    if (form.op() == Op::And) return value(form);  // equal matrices are equal in every entry
    const auto it = assigned.find(form);
    if (it != assigned.end()) return truth_of(it->second);
    if (undecided == Expr()) undecided = form;
    return Truth::Unknown;
  }

  Expr goal;
  Exprs premises;
  Assignment assigned;
  Expr undecided;
  int count = 0;
};
}  // namespace
Theorem tautology(Expr goal, const Theorems& from) {
  if (!Cases(goal, from).all_good())
    refuse("does not follow by propositional logic: " + brief(goal));
  return Theorem(united(from), goal, {"tautology", from, {goal}});
}

// INSTANTIATE. The theorem holds for all values of its variables, so for the values of the terms;
// an integer variable gets an integer only (substitute checks it); bound variables are indices, so
// that nothing is captured.
Theorem instantiate(const Theorem& t, const Substitution& s) {
  Exprs hypotheses;
  for (Expr f : t.hypotheses()) hypotheses.push_back(substitute(f, s));
  return Theorem(hypotheses, substitute(t.conclusion(), s), {"instantiate", {t}, {}, s});
}

// GENERALIZE. v is not free in H: whatever v is, H stays true, so c is true.
Theorem generalize(Expr v, const Theorem& t) {
  const Expr conclusion = all(v, t.conclusion());
  check_not_in_hypotheses(v, t);
  return Theorem(t.hypotheses(), conclusion, {"generalize", {t}, {v}});
}
// SPECIALIZE. What holds for every value holds for a term's, of the same sort (open checks).
Theorem specialize(const Theorem& t, Expr term) {
  return Theorem(t.hypotheses(), open(t.conclusion(), term), {"specialize", {t}, {term}});
}

// REWRITE. Equal values in the same place. l and r hold no loose index, so that the equation means
// the same under every quantifier.
Theorem rewrite(const Theorem& equation, const Theorem& t) {
  const Expr e = equation.conclusion();
  if (e.op() != Op::Eq) refuse("not an equation: " + brief(e));
  return Theorem(united({equation, t}), replace(t.conclusion(), e.arg(0), e.arg(1)),
                 {"rewrite", {equation, t}});
}
// RESTATE. The same formula up to terms that are equal as polynomials and matrices that are equal
// entry by entry: the same truth value for all values of the variables.
Theorem restate(Expr goal, const Theorem& t) {
  if (!(canonical(goal) == canonical(t.conclusion())))
    refuse("not the same statement: " + brief(goal) + " and " + brief(t.conclusion()));
  return Theorem(t.hypotheses(), goal, {"restate", {t}, {goal}});
}
}  // namespace kernel
