// Polynomials with rational coefficients over opaque atoms: variables, bound indices, functions of
// canonical arguments, entries. The only algebra that the kernel trusts: +, *, comparison with 0.
#pragma once

#include <functional>

#include "kernel/expr.hpp"

namespace kernel {
using Monomial = std::vector<std::pair<Expr, int>>;  ///< atoms in order of id, exponents >= 1
using Polynomial = std::map<Monomial, cln::cl_RA>;   ///< no coefficient is 0

Polynomial one();
int degree(const Monomial& m, Expr atom);
/// The youngest atom inv(d) of p with a known d, else no Expr.
Expr youngest_inverse(const Polynomial& p, const std::function<bool(Expr)>& is_known);
// Refused: exponents above 1,000,000, products of over a million monomials, numbers of more bits.
Polynomial operator+(Polynomial a, const Polynomial& b);
Polynomial operator-(Polynomial a, const Polynomial& b);
Polynomial operator*(const Polynomial& a, const Polynomial& b);
Polynomial scaled(const Polynomial& a, const cln::cl_RA& q);

/// Equal in value to the term, whatever the values of the atoms are; computed once.
const Polynomial& polynomial(Expr term);
Expr expression(const Polynomial& p);
/// Every largest term in e as an expanded polynomial: the same value, or the same truth value.
Expr canonical(Expr e);
}  // namespace kernel
