// SPDX-License-Identifier: GPL-2.0-or-later
// A block and the ball: the matrix Gamma of their collision, a rotation after a reflection.
#include "derivation/symbols.hpp"

namespace derivation {
void show_angle(Book& book, const Theorem& is, const Theorems& hypotenuse, Expr cosine, Expr sine) {
  const Expr angle = left(is), t = right(is).arg(1).arg(0);
  const Theorem half = linear(eq(atan(t), angle / 2), {is});
  const auto show = [&](const std::string& of, const char* words, const Theorem& theorem) {
    return book.show(of + angle.name(), "table:trig", words, theorem);
  };
  const auto at_half = [&](const char* axiom_name) {
    return rewritten(hypotenuse, rewrite(half, at(axiom_name, {{x, t}})));
  };
  const Theorems of_half{show("cos_half_", "Its half is an arctangent,", at_half("cos atan")),
                         show("sin_half_", "and", at_half("sin atan"))};
  show("cos_", "The double angle", equation(cos(angle), cosine, of_half, {angle / 2}));
  show("sin_", "and", equation(sin(angle), sine, of_half, {angle / 2}));
}

void ball(Book& book) {
  book.chapter("ball", "A block and the ball", {alpha_positive, lt(0, M)});
  Exprs after;
  Theorems velocities;
  for (const char* id : {"contact.v_1", "contact.v_2"}) {
    const Theorem v = cut(positive(alpha * M), instantiate(book[id], {{M_1, M}, {M_2, alpha * M}}));
    after.push_back(simplified(right(v), {u_1, u_2}));
    velocities.push_back(chain(v, equation(right(v), after.back())));
  }
  book.show("velocities", "A block of mass M and the ball of mass alpha M:", both(velocities));

  // In terms of (u_1, sqrt(alpha) u_2): scaled coefficients of u_1 and u_2.
  const Expr s = sqrt(alpha);
  const auto coefficient = [&](std::size_t row, int in_u_1) {
    return substitute(after[row], {{u_1, in_u_1}, {u_2, 1 - in_u_1}});
  };
  const Expr scaled_matrix = simplified(matrix(
      2, {coefficient(0, 1), coefficient(0, 0) / s, s * coefficient(1, 1), coefficient(1, 0)}));
  const Theorem gamma =
      book.name("Gamma", {alpha}, scaled_matrix, {alpha_positive},
                "With the ball's velocities times sqrt(alpha), the coefficients form the matrix");
  book.show("collision", "so that a collision is a linear map:",
            equation(column({v_1, s * v_2}), times(Gamma(), column({u_1, s * u_2})),
                     velocities + Theorems{gamma}));
  book.show("Gamma_paper", "eq:Gamma", "As the paper writes it:",
            equation(Gamma(),
                     matrix(2, {(1 - alpha) / (1 + alpha), 2 * s / (1 + alpha), 2 * s / (1 + alpha),
                                -(1 - alpha) / (1 + alpha)}),
                     {gamma}));
  book.show("Gamma_orthogonal", "It is orthogonal,",
            equation(times(Gamma(), transpose(Gamma())), identity(2), {gamma}));
  book.show("Gamma_determinant", "with determinant -1:", equation(det(Gamma()), -1, {gamma}));

  const Theorem angle = book.name("theta", {alpha}, 2 * atan(s), {alpha_positive},
                                  "The angle theta:", "def:theta theta-txt");
  show_angle(book, angle, {equation(1 + power(s, 2), 1 + alpha)}, (1 - alpha) / (1 + alpha),
             2 * s / (1 + alpha));
  const Theorem plane = book.name("lambda", {x}, matrix(2, {cos(x), -sin(x), sin(x), cos(x)}), {},
                                  "A rotation of the plane");
  const Theorem mirror = book.name("P_2", {}, matrix(2, {1, 0, 0, -1}), {}, "and a reflection:");
  const Theorems turned_rules{gamma, book["ball.cos_theta"], book["ball.sin_theta"],
                              at(plane, {{x, theta()}}), mirror};
  book.show("Gamma_theta", "def:gamma", "With it Gamma is",
            equation(Gamma(), matrix(2, {cos(theta()), sin(theta()), sin(theta()), -cos(theta())}),
                     turned_rules));
  book.show("Gamma_rotation", "def:gamma", "a rotation after a reflection:",
            equation(Gamma(), times(fun("lambda", {theta()}), fun("P_2", {})), turned_rules));
}
}  // namespace derivation
