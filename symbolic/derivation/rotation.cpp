// SPDX-License-Identifier: GPL-2.0-or-later
// Lambda is a rotation by psi about one axis: the frame R in which it is lambda_3(psi).
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr dot(const Exprs& p, const Exprs& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Exprs cross(const Exprs& p, const Exprs& q) {
  Exprs out;
  for (std::size_t i = 0; i < 3; ++i)
    out.push_back(simplified(p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3]));
  return out;
}
/// The axis of a rotation: what it leaves as it is, its first component 1, by solving (Lambda - 1)
/// e = 0.
Exprs axis_of(Expr rotation_matrix) {
  const Expr p = real("e_2"), q = real("e_3");
  const Exprs direction{1, p, q};
  Exprs rows;
  for (int i = 0; i < 3; ++i) {
    Expr image = 0;
    for (int l = 0; l < 3; ++l)
      image = image + entry(rotation_matrix, i, l) * direction[static_cast<std::size_t>(l)];
    rows.push_back(eq(image, direction[static_cast<std::size_t>(i)]));
  }
  const Exprs solution = solve(rows, {p, q});
  return {1, solution[0], solution[1]};
}

void angle(Book& book, Expr lambda) {
  const Theorem mass = assume(alpha_positive);
  const Theorem p1 = positive(1 + alpha, {mass});
  // 1 + 2 cos(psi) is the trace; tan^2(psi/2) = (1 - cos(psi))/(1 + cos(psi)).
  const Expr trace = entry(lambda, 0, 0) + entry(lambda, 1, 1) + entry(lambda, 2, 2);
  const Expr cosine = simplified((trace - 1) / 2);
  const Expr tangent_squared = simplified((1 - cosine) / (1 + cosine));
  const Expr t = sqrt(tangent_squared);
  const Theorem definition = define("psi", {alpha}, 2 * atan(t));
  restrict_domain("psi", {alpha}, alpha_positive);
  book.show("psi", "def:psi def:psi-app",
            "From the trace of Lambda, 1 + 2 cos(psi), its angle psi:",
            under({alpha_positive}, definition));
  const Theorem under_root = positive(tangent_squared, {mass});
  const Theorem root_t = root_squared(under_root);
  const Theorem half = linear(eq(atan(t), psi() / 2), {definition});
  const Theorem inside = equation(1 + power(t, 2), power(1 + alpha, 2), {root_t});
  const Theorem root = root_is(power(1 + alpha, 2), 1 + alpha, p1);
  const auto at_half = [&](const std::string& axiom_name) {
    return rewrite(root, rewrite(inside, rewrite(half, use(axiom_name, {{x, t}}))));
  };
  const Theorem cos_half =
      book.show("cos_half_psi", "table:trig", "Its half is an arctangent,", at_half("cos atan"));
  const Theorem sin_half = book.show("sin_half_psi", "table:trig", "and", at_half("sin atan"));
  book.show("psi_range", "", "The range of psi:",
            both({linear(lt(0, psi()), {definition, positive(atan(t), {positive(t, {mass})})}),
                  linear(lt(psi(), pi()), {definition, part(use("atan range", {{x, t}}), 1)})}));
  const Theorem range = book["rotation.psi_range"];
  const Theorem signs =
      book.show("half_signs", "", "so that half of it has a positive sine and a positive cosine:",
                both({use("sin positive", {{x, psi() / 2}},
                          {linear(lt(0, psi() / 2), {part(range, 0)}),
                           linear(lt(psi() / 2, pi()), {part(range, 0), part(range, 1)})}),
                      linear(lt(0, cos(psi() / 2)), {cos_half, positive(1 / (1 + alpha), {p1})})}));
  know(range);
  know(signs);
  const auto doubled = [&](Expr l, Expr r) {
    return equation(l, r, angles({l}, {psi() / 2}, false) + Theorems{cos_half, sin_half, root_t},
                    {p1});
  };
  book.show("cos_psi", "table:trig", "The double angle", doubled(cos(psi()), cosine));
  book.show("sin_psi", "table:trig", "and", doubled(sin(psi()), 2 * t / power(1 + alpha, 2)));
  book.show(
      "trace", "", "agrees with the trace:",
      equation(
          entry(Lambda(), 0, 0) + entry(Lambda(), 1, 1) + entry(Lambda(), 2, 2), 1 + 2 * cos(psi()),
          entries(book["cycle.Lambda"]) + Theorems{book["rotation.cos_psi"], root_squared(mass)},
          {p1}));
}
}  // namespace

Roots roots_of(Book& book) {
  const Theorem mass = assume(alpha_positive);
  const Theorem p2 = positive(2 + alpha, {mass});
  const Theorem two = positive(2);
  const Expr s = sqrt(alpha), w = sqrt(2 + alpha);
  const Theorem ps = positive(s, {mass});
  const Theorem pw = positive(w, {p2});
  const Theorems squares{root_squared(mass), root_squared(p2), root_squared(two)};
  const Theorem split = root_is(book["rotation.psi"].conclusion().arg(1).arg(1).arg(0).arg(0),
                                s * w, positive(s * w, {ps, pw}), squares);
  return {squares + Theorems{split},
          {positive(1 + alpha, {mass}), p2, ps, pw, positive(sqrt(2)),
           positive(sqrt(2) * w, {positive(sqrt(2)), pw}), mass}};
}

void rotation(Book& book) {
  const Theorem def_lambda = book["cycle.Lambda"];
  const Expr lambda = def_lambda.conclusion().arg(1);
  book.chapter("rotation", "The rotation", {alpha_positive});
  angle(book, lambda);
  const Roots roots = roots_of(book);
  const Theorems rules = roots.squares + entries(def_lambda) +
                         Theorems{book["rotation.cos_psi"], book["rotation.sin_psi"]};

  // The axis, and two more unit vectors that complete it.
  const Exprs axis = axis_of(lambda);
  const Exprs first = cross({0, 0, 1}, axis);
  const Exprs second = cross(axis, first);
  const auto length = [](const Exprs& v) { return sqrt(simplified(dot(v, v))); };
  const Expr norms[]{length(first), length(axis) * length(first), length(axis)};
  Exprs columns;
  for (std::size_t i = 0; i < 3; ++i)
    for (const auto& [vector, norm] :
         {std::pair{first[i], norms[0]}, std::pair{second[i], norms[1]},
          std::pair{axis[i], norms[2]}})
      columns.push_back(vector == Expr(0) ? vector : vector / norm);
  const Theorem frame = define("R", {alpha}, matrix(3, columns));
  restrict_domain("R", {alpha}, alpha_positive);
  book.show("R", "def:R", "A frame with the axis of Lambda as its third unit vector:",
            under({alpha_positive}, frame));
  const Theorems with_frame = entries(frame) + rules;
  const Expr w = sqrt(2 + alpha);
  const auto third = column({entry(R(), 0, 2), entry(R(), 1, 2), entry(R(), 2, 2)});
  book.show("axis", "", "Lambda leaves its axis as it is,",
            matrix_equation(times(Lambda(), third), third, with_frame, roots.divisors));
  book.show(
      "axis_paper", "", "which is along the roots of the masses:",
      matrix_equation(third, column({1 / w, 1 / w, sqrt(alpha) / w}), with_frame, roots.divisors));
  const Theorem a2 = positive(alpha / (2 * (2 + alpha)), {assume(alpha_positive)});
  const Theorem quotient = root_is(alpha / (2 * (2 + alpha)), sqrt(alpha) / (sqrt(2) * w),
                                   positive(sqrt(alpha) / (sqrt(2) * w), {assume(alpha_positive)}),
                                   roots.squares, roots.divisors);
  const Theorem other =
      root_is(2 / (2 + alpha), sqrt(2) / w, positive(sqrt(2) / w, {assume(alpha_positive)}),
              roots.squares, roots.divisors);
  const Expr r2 = sqrt(2);
  const Expr q = sqrt(alpha / (2 * (2 + alpha)));
  know(a2);
  book.show("R_paper", "eq:R-app", "As the paper writes it:",
            matrix_equation(R(),
                            matrix(3, {-1 / r2, -q, 1 / w, 1 / r2, -q, 1 / w, 0,
                                       sqrt(2 / (2 + alpha)), sqrt(alpha) / w}),
                            Theorems{quotient, other} + with_frame, roots.divisors));
  book.show("R_orthogonal", "", "The frame is orthogonal,",
            matrix_equation(times(transpose(R()), R()), identity(3), with_frame, roots.divisors));
  book.show("R_determinant", "",
            "and right-handed:", equation(det(R()), 1, with_frame, roots.divisors));
  const Theorem turn_3 =
      define("lambda_3", {x}, matrix(3, {cos(x), -sin(x), 0, sin(x), cos(x), 0, 0, 0, 1}), 0);
  book.show("lambda_3", "eq:lambda-3", "A rotation about the third axis:", turn_3);
  const Theorems turned_rules = entries(instantiate(turn_3, {{x, psi()}})) + with_frame;
  book.show("Lambda_in_frame", "eq-app:lambda-R",
            "In this frame Lambda is such a rotation, by psi:",
            matrix_equation(times(transpose(R()), times(Lambda(), R())), lambda_3(psi()),
                            turned_rules, roots.divisors));
  book.show("Lambda_R", "", "so that",
            matrix_equation(Lambda(), times(times(R(), lambda_3(psi())), transpose(R())),
                            turned_rules, roots.divisors));
}
}  // namespace derivation
