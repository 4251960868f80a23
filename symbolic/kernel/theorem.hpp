// A theorem is hypotheses |- conclusion, and only the rules below make one.
// H |- c says: for all values of the free variables (real or integer, by their sort) for which
// every formula of H is true, c is true. There are no global laws: physics is in H. Taken without
// proof are the definitions and the axioms of real analysis (kernel/axioms.cpp), nothing else.
#pragma once

#include <memory>
#include <optional>

#include "kernel/expr.hpp"

namespace kernel {
class Theorem;
using Theorems = std::vector<Theorem>;
struct Certificate;
struct Step;

// Logic
/// f |- f
Theorem assume(Expr f);
/// H |- c gives H - {f} |- f implies c.
Theorem discharge(Expr f, const Theorem& t);
/// The goal follows from the conclusions by propositional logic. Refused above 20,000 cases.
Theorem tautology(Expr goal, const Theorems& from);
/// Free variables by terms of their sort, in the hypotheses and in the conclusion.
Theorem instantiate(const Theorem& t, const Substitution& s);
/// H |- c gives H |- for every v: c, where v is free in no formula of H.
Theorem generalize(Expr variable, const Theorem& t);
/// H |- for every v: c gives H |- c with the term for v.
Theorem specialize(const Theorem& t, Expr term);
/// H |- l = r and K |- c give H, K |- c with r for every l.
Theorem rewrite(const Theorem& equation, const Theorem& t);
/// The same statement, its terms equal as polynomials.
Theorem restate(Expr goal, const Theorem& t);

// Arithmetic
/// l = r, l < r or l <= r from equations and inequalities, by a certificate (below).
Theorem arithmetic(Expr goal, const Certificate& c);
/// H |- f[lo] and K |- (lo <= n and f) implies f[n+1] give H, K |- lo <= n implies f.
Theorem induction(Expr n, Expr lo, Expr f, const Theorem& base, const Theorem& step);

// Definitions: each makes new names or refuses, and is a conservative extension.
/// name(params) = term, for a term or a matrix; name(params) if and only if term, for a formula.
/// The first `hidden` parameters are not printed where they stand as they are; -1 hides all.
Theorem define(const std::string& name, const Exprs& params, Expr term, int hidden = -1);
/// For each i: names_i(params, 0) = start_i, then, for each i: 0 <= n implies names_i(params, n+1)
/// = next_i with names_j(params, n) for every previous_j.
Theorems define_recursive(const std::vector<std::string>& names, const Exprs& params, Expr n,
                          const Exprs& previous, const Exprs& start, const Exprs& next);
/// a^0 = 1 and (0 <= n implies a^(n+1) = a a^n), for a square matrix.
Theorem matrix_power(Expr a, Expr n);
/// lo <= n and f implies lo <= name and f[name] and name <= n: the least integer from lo on with f.
Theorem define_least(const std::string& name, const Exprs& params, Expr n, Expr lo, Expr f);

// Axioms
Theorem axiom(const std::string& name);
std::vector<std::string> axiom_names();

/// Copied, never moved: a theorem that has been moved from would have lost its hypotheses.
class Theorem {
public:
  Theorem(const Theorem&) = default;
  Theorem& operator=(const Theorem&) = default;
  ~Theorem() = default;
  Exprs hypotheses() const;
  Expr conclusion() const;
  Step step() const;  ///< how it was made, for an independent checker

private:
  friend Theorem assume(Expr);
  friend Theorem discharge(Expr, const Theorem&);
  friend Theorem tautology(Expr, const Theorems&);
  friend Theorem instantiate(const Theorem&, const Substitution&);
  friend Theorem generalize(Expr, const Theorem&);
  friend Theorem specialize(const Theorem&, Expr);
  friend Theorem rewrite(const Theorem&, const Theorem&);
  friend Theorem restate(Expr, const Theorem&);
  friend Theorem arithmetic(Expr, const Certificate&);
  friend Theorem induction(Expr, Expr, Expr, const Theorem&, const Theorem&);
  friend Theorem define(const std::string&, const Exprs&, Expr, int);
  friend Theorems define_recursive(const std::vector<std::string>&, const Exprs&, Expr,
                                   const Exprs&, const Exprs&, const Exprs&);
  friend Theorem matrix_power(Expr, Expr);
  friend Theorem define_least(const std::string&, const Exprs&, Expr, Expr, Expr);
  friend Theorem axiom(const std::string&);
  Theorem(Exprs hypotheses, Expr conclusion, Step step);  // Refused: what is not a formula

  struct Content;
  std::shared_ptr<const Content> content;
};

/// Proves D = r - l of a goal l = r, l < r or l <= r:
///   m*D = sum of cofactor*(q - p) over equations |- p = q
///       + sum of coefficient * product of (q - p) over |- p < q or |- p <= q * roots squared,
/// m the product of q - p over multipliers |- p < q (for a goal l = r also |- not p = q).
struct Certificate {
  struct Product {
    cln::cl_RA coefficient;
    Theorems factors = {};
    Exprs roots = {};
  };
  std::vector<std::pair<Expr, Theorem>> equations = {};
  std::vector<Product> products = {};
  Theorems multipliers = {};
  Theorems nonzero = {};  ///< |- not p = q or |- p < q: then inv(q - p) may be cleared
};

/// How a theorem was made. For a definition, extras hold its parts.
struct Step {
  std::string rule;
  Theorems premises = {};
  Exprs extras = {};
  Substitution substitution = {};
  std::optional<Certificate> certificate = {};
};

std::string text(const Theorem& t);      ///< H |- c
Exprs united(const Theorems& premises);  ///< all their hypotheses, each once
/// Refused: v is free in a hypothesis.
void check_not_in_hypotheses(Expr v, const Theorem& t);

// Where functions are meant to be used. They are total in the kernel, so that no theorem depends on
// this; but nothing should be shown that has 1/x where x may be 0.
/// A condition on the function's parameters. Once for each name.
void restrict_domain(const std::string& name, const Exprs& params, Expr condition);
/// For each term with a restricted domain its condition, under what the formula says before it.
/// Predicates are unfolded by their definitions.
Exprs needs(Expr formula);
/// The same for hypotheses |- conclusion: each hypothesis under those before it; the conclusion.
Exprs needs(const Theorem& t);
}  // namespace kernel
