// SPDX-License-Identifier: GPL-2.0-or-later
// Equations of terms and of matrices: cofactors are found here and checked by the kernel.
#pragma once
#include <optional>

#include "algebra/logic.hpp"
#include "kernel/polynomial.hpp"

namespace algebra {
/// The quotient of two monomials, if it is one.
std::optional<Monomial> divided(const Monomial& monomial, const Monomial& by);
/// q - p of p = q, p < q, p <= q or not p = q.
Expr gap(const Theorem& relation);
/// `goal` (l = r of terms or of matrices, or several): each equation of `facts` (monomial = term)
/// rewrites a monomial; denominators are cleared that `facts` (0 < d, not d = 0) or `positive` say
/// not to be 0; squares of roots are rewritten; sines and cosines are expanded in those of the
/// angles `bases`, if any. Throws Refused, with what is left over, if that does not end in 0 = 0.
Theorem equation(Expr goal, const Theorems& facts = {}, const Exprs& bases = {});
Theorem equation(Expr l, Expr r, const Theorems& facts = {}, const Exprs& bases = {});
/// The same after the goal is multiplied by `factors`, each proved not 0.
Theorem cancel(Expr goal, const Theorems& factors, const Theorems& facts = {},
               const Exprs& bases = {});
/// `arithmetic`, where multipliers are divisors, too.
Theorem certified(Expr goal, Certificate c);
/// x = the rest of an equation in which the monomial x is a term.
Theorem solved_for(Expr x, const Theorem& equation);
/// l = m and m = r give l = r.
Theorem chain(const Theorem& a, const Theorem& b);
/// l = r gives r = l.
Theorem turned(const Theorem& e);
/// The equations of the entries of an equation of matrices, row by row.
Exprs entry_equations(Expr matrix_equation);
Theorems entries(const Theorem& matrix_equation);
/// |- sqrt(x)^2 = x from 0 <= x or 0 < x.
Theorem root_squared(const Theorem& not_negative);
/// |- sqrt(x) = t from t^2 = x and 0 < t.
Theorem root_of(const Theorem& square, const Theorem& t_positive);
/// The same where `equation` and `positive` show both.
Theorem root_is(Expr x, Expr t, const Theorems& facts = {});
}  // namespace algebra
