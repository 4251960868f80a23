// SPDX-License-Identifier: GPL-2.0-or-later
// What the plane and space share in the chapter on orthogonal matrices.
#pragma once
#include "derivation/symbols.hpp"

namespace derivation {
inline Expr matrix_of_names(int size, const std::string& name = "o") {
  Exprs names;
  for (int i = 1; i <= size; ++i)
    for (int l = 1; l <= size; ++l)
      names.push_back(real(name + "_" + std::to_string(i) + std::to_string(l)));
  return matrix(size, names);
}
inline Expr gram(Expr o) { return times(transpose(o), o); }
/// The third axis of the frame F
inline Expr third_axis() { return column({real("r_13"), real("r_23"), real("r_33")}); }
/// |- det(O)^2 = 1 from O^T O = 1
inline Theorem squared_determinant(Expr o, const Theorem& is) {
  const Expr square = power(det(o), 2);
  return linear(eq(square, 1), {rewrite(is, equation(square, det(gram(o))))});
}
/// |- x = 0 from x^2 = 0
inline Theorem is_0(const Theorem& square) {
  const Expr of = left(square).arg(0);
  const Theorem none = given(neq(of, 0), [&](const Theorem& other) {
    return arithmetic(eq(of, 0), {.equations = {{-1, square}}, .multipliers = {other}});
  });
  return tautology(eq(of, 0), {none});
}
/// t != -1 |- 1 + t != 0
inline Theorem one_more_not_0(Expr t) {
  return tautology(neq(1 + t, 0), {assume(neq(t, -1)), linear(imp(eq(1 + t, 0), eq(t, -1)))});
}

/// |- matrix = name
inline Theorem named(const Theorem& is) { return equation(right(is), left(is), {is}); }
/// The same with the names of matrices, in hypotheses, too.
Theorem with_names(const Book& book, Theorem t);
/// The part about space, from what is shown for a rotation of the plane.
void in_space(Book& book, const Theorems& of_plane);
}  // namespace derivation
