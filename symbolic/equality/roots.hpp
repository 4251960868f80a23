// Roots and moduli for the kernel: each by simpler ones, with signs and with bounds of numbers.
#pragma once

#include "equality/normal_form.hpp"

namespace equality {
using algebra::operator+;
using algebra::Theorem;
using algebra::Theorems;

/// A modulus, a square root, or another root of an order that is not too high.
bool is_root(Expr e);
/// Of +, *, quotients, roots, symbols and sines of parts of pi.
bool is_algebraic_term(Expr e);
inline bool is_constant(Expr e) { return kernel::free_variables(e).empty(); }
/// Whether it is p < q or p <= q.
inline bool is_bound(const Theorem& t) {
  return t.conclusion().op() == Op::Lt || t.conclusion().op() == Op::Le;
}

/// What is known of the roots of a goal. What may have no value has no definition among them.
class Roots {
public:
  /// `outside`: what is assumed, without the case that is being proved. `plain`: each root stays.
  Roots(const Forms& of_terms, const Exprs& parts, const Theorems& outside, bool plain)
      : forms(of_terms), is_plain(plain), typed(parts.begin(), parts.end()), certain(outside) {}

  Forms forms;
  Theorems facts = {};
  /// Signs that are known before anything is added; then those of sums, too.
  Theorems signs = {};
  std::set<Expr> definitions = {};  ///< r^n = x and 0 <= r, which facts assume
  Enclosures bounds{facts};         ///< of roots of numbers and cosines

  /// Notes the orders of roots that a term has, so that they are written by one.
  void see(Expr term);
  /// Adds what is known of roots in the term, inner ones first.
  void add(Expr term);
  /// Its factors are not 0 where it is not; one has its sign where the others are positive.
  void add_factors(const Theorem& given);
  /// The sign of a constant; false where it is not decided, or the term is no constant.
  bool add_sign(Expr constant);
  /// One root as both sides are equal, if it is that: two could be written by one another.
  bool solve_for_one(Expr goal, const std::function<Theorem(Expr)>& rest);

private:
  bool is_plain;
  std::set<Expr> typed;                   // parts of the goal
  Theorems certain;                       // whatever the case
  std::map<Expr, cln::cl_I> orders = {};  // of each factor
  std::set<Expr> seen = {};
  Exprs others = {};  // that are not known by simpler ones

  using Simpler = std::optional<Expr>(Expr root);
  Simpler of_signed, of_sum, by_factors, of_product;
  Expr least_root(Expr x, int n);
  bool has_value(Expr root) const;
  void enclose(Expr root);
  void add_sum(Expr sum);
  void add_sign_of(Expr root);
};
}  // namespace equality
