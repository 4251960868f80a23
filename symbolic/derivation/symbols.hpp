// SPDX-License-Identifier: GPL-2.0-or-later
// The paper's symbols as terms, and what every chapter includes.
#pragma once
#include "algebra/angles.hpp"
#include "algebra/equations.hpp"
#include "algebra/ginac.hpp"
#include "algebra/linear.hpp"
#include "algebra/signs.hpp"
#include "derivation/book.hpp"
#include "kernel/defined.hpp"

namespace derivation {
using namespace algebra;

inline const Expr alpha = real("alpha");
inline const Expr V = real("V");
inline const Expr n = integer("n");
inline const Expr j = integer("j");
inline const Expr k = integer("k");
inline const Expr x = real("x");
inline const Expr y = real("y");
inline const Expr alpha_positive = lt(0, alpha);
inline const Expr V_positive = lt(0, V);

Expr rational(int p, int q);
/// After j collisions: the velocities of A, B and C; whose turn it is, 1 for P and -1 for Q.
Expr A(Expr j);
Expr B(Expr j);
Expr C(Expr j);
Expr turn(Expr j);
/// The paper's velocities, just after P_n and Q_n.
Expr a(Expr n);
Expr b(Expr n);
Expr c(Expr n);
Expr c_prime(Expr n);
Expr V_vector(Expr n);  ///< (a_n, b_n, sqrt(alpha) c'_n)
Expr theta();
Expr psi();
Expr V_CM();
Expr Gamma();
Expr Gamma_A();
Expr Gamma_B();
Expr Lambda();
Expr R();
Expr lambda_3(Expr angle);
Expr approach(Expr j);  ///< the speed with which the two bodies of collision j approach before it
Expr N();
Expr N_A();
Expr N_B();
Expr identity(int size);
Expr column(const Exprs& entries);

/// |- sqrt(alpha (2 + alpha)) = sqrt(alpha) sqrt(2 + alpha)
Theorem root_split(Book& book);
/// |- ceil(x) = k if and only if k - 1 < x and x <= k
Theorem ceiling_is();
/// 0 < pi/d and pi/d < pi/2 for a denominator d that `facts` say to be above 2.
Theorems range_of(Expr d, const Theorems& facts);

// The chapters, one file each, in the order of the book.
void contact(Book& book);
void cycle(Book& book);
void cycle_matrix(Book& book);
void rotation(Book& book);
void powers(Book& book);
void counting(Book& book);
void multiples(Book& book);
void table(Book& book);
void constraints(Book& book);
void thresholds(Book& book);
void ratios(Book& book);
void terminal(Book& book);
void orthogonal(Book& book);
void minima(Book& book);
void small_alpha(Book& book);
void evaluators(Book& book);
void radicals(Book& book);
void exact_forms(Book& book);

}  // namespace derivation
