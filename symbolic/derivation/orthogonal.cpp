// SPDX-License-Identifier: GPL-2.0-or-later
// Orthogonal matrices of the plane and of space: which of them are rotations.
#include "derivation/orthogonal.hpp"

namespace derivation {
namespace {
/// Names for matrices of the plane and of space.
void named_matrices(Book& book) {
  const auto named = [&](const std::string& name, Expr m, const std::string& words) {
    const Theorem is = define(name, kernel::entries(m), m);  // none of its entries is printed
    book.show("def_" + name, words, is);
  };
  named("Q", matrix_of_names(2), "Any matrix of the plane,");
  named("O", matrix_of_names(3), "any matrix of space,");
  named("F", matrix_of_names(3, "r"), "a frame,");
  named("f_3", third_axis(), "its third axis,");
  named("S", matrix_of_names(3, "m"), "a matrix as seen in that frame,");
  book.define("I", {}, identity(3), {}, "and the identity:");
}
/// O^T O = 1 |- det(O) is 1 or -1
Theorem orthogonal(Book& book, int size) {
  const Expr o = matrix_of_names(size), d = det(o);
  const Theorem is = assume(eq(gram(o), identity(size)));
  const Theorem other = given(neq(d, 1), [&](const Theorem& t) {
    // (1 - d)(-1 - d) = d^2 - 1
    return arithmetic(eq(d, -1),
                      {.equations = {{-1, squared_determinant(o, is)}}, .multipliers = {t}});
  });
  book.show(size == 2 ? "plane_determinant" : "space_determinant",
            size == 2 ? "An orthogonal matrix of the plane has the determinant 1 or -1,"
                      : "An orthogonal matrix of space has the determinant 1 or -1, too,",
            with_names(book, tautology(logic_or({eq(d, 1), eq(d, -1)}), {other})));
  return is;
}

/// A rotation, which is returned, or after a reflection, where the determinant is -1.
Theorems in_the_plane(Book& book, const Theorem& is) {
  const Expr o = matrix_of_names(2);
  const Expr p = entry(o, 0, 0), q = entry(o, 0, 1), r = entry(o, 1, 0), s = entry(o, 1, 1);
  const Theorems products = entries(is);
  const Theorem unit = solved_for(power(r, 2), products[0]);
  const Expr slope = r / (1 + p), angle = atan(slope);
  const Theorem moves = know(one_more_not_0(p)), at_end = assume(eq(p, -1));
  const auto of_angle = [&](Expr l, Expr value) {
    return equation(l, value,
                    {at("cos atan", {{x, slope}}), at("sin atan", {{x, slope}}), unit, moves},
                    {angle});
  };
  const Theorem cosine = of_angle(cos(2 * angle), p), sine = of_angle(sin(2 * angle), r);
  const Theorem r_is_0 = is_0(equation(power(r, 2), 0, {unit, at_end}));
  Theorems shown;
  for (const int sign : {1, -1}) {
    const Theorem value = restate(eq(p * s - q * r, sign), assume(eq(det(o), sign)));
    // sign p - s = p (p s - q r) - s (p^2 + r^2)
    const Theorem s_is = arithmetic(
        eq(s, Expr(sign) * p), {.equations = {{-s, products[0]}, {p, value}, {r, products[1]}}});
    const Theorem q_is = arithmetic(
        eq(q, Expr(-sign) * r), {.equations = {{-q, products[0]}, {-r, value}, {p, products[1]}}});
    const auto turned_by = [&](Expr a, const Theorems& facts) {
      const Expr turn = fun("lambda", {a});
      return equation(
          o, sign == 1 ? turn : times(turn, fun("P_2", {})),
          Theorems{at(book["ball.lambda"], {{x, a}}), book["ball.P_2"], s_is, q_is} + facts);
    };
    const auto show = [&](const char* kind, const char* words, const Theorem& t) {
      book.show(std::string(sign == 1 ? "rotation" : "reflection") + kind, words,
                with_names(book, t));
      shown.push_back(t);
    };
    show("",
         sign == 1 ? "With determinant 1 it is a rotation of the plane,"
                   : "With determinant -1 it is a rotation after a reflection,",
         turned_by(2 * angle, {cosine, sine}));
    show("_half", "or half a turn,",
         turned_by(pi(), {axiom("cos pi"), axiom("sin pi"), at_end, r_is_0}));
  }
  return shown;
}
}  // namespace

Theorem with_names(const Book& book, Theorem t) {
  for (const char* of : {"Q", "O", "F", "f_3", "S", "I", "X"}) {
    const std::string id = std::string("orthogonal.def_") + of;
    if (!book.has(id)) continue;
    const Theorem is = book[id], name = named(is);
    for (const Expr& h : t.hypotheses()) {
      const Expr named = rewrite(name, assume(h)).conclusion();
      if (named != h) t = cut(rewrite(is, assume(named)), t);
    }
    t = rewrite(name, t);
  }
  return t;
}
void orthogonal(Book& book) {
  book.chapter("orthogonal", "Orthogonal matrices", {});
  named_matrices(book);
  const Theorems of_plane = in_the_plane(book, orthogonal(book, 2));
  orthogonal(book, 3);
  in_space(book, of_plane);
}
}  // namespace derivation
