// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/symbols.hpp"

namespace derivation {
Expr rational(int p, int q) { return Expr(cln::cl_RA(p) / q); }
Expr A(Expr i) { return fun("A", {alpha, V, i}); }
Expr B(Expr i) { return fun("B", {alpha, V, i}); }
Expr C(Expr i) { return fun("C", {alpha, V, i}); }
Expr turn(Expr i) { return fun("turn", {i}); }
Expr a(Expr i) { return fun("a", {alpha, V, i}); }
Expr b(Expr i) { return fun("b", {alpha, V, i}); }
Expr c(Expr i) { return fun("c", {alpha, V, i}); }
Expr c_prime(Expr i) { return fun("c'", {alpha, V, i}); }
Expr V_vector(Expr i) { return fun("V_", {alpha, V, i}); }
Expr theta() { return fun("theta", {alpha}); }
Expr psi() { return fun("psi", {alpha}); }
Expr V_CM() { return fun("V_CM", {alpha, V}); }
Expr Gamma() { return fun("Gamma", {alpha}); }
Expr Gamma_A() { return fun("Gamma_A", {alpha}); }
Expr Gamma_B() { return fun("Gamma_B", {alpha}); }
Expr Lambda() { return fun("Lambda", {alpha}); }
Expr R() { return fun("R", {alpha}); }
Expr lambda_3(Expr angle) { return fun("lambda_3", {angle}); }
Expr approach(Expr i) { return fun("approach", {alpha, V, i}); }
Expr N() { return fun("N", {alpha, V}); }
Expr N_A() { return fun("N_A", {alpha, V}); }
Expr N_B() { return fun("N_B", {alpha, V}); }
Expr identity(int size) {
  Exprs entries;
  for (int i = 0; i < size * size; ++i) entries.push_back(i % (size + 1) == 0 ? 1 : 0);
  return matrix(size, entries);
}
Expr column(const Exprs& entries) { return matrix(1, entries); }
}  // namespace derivation
