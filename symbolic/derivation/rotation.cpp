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
void angle(Book& book, Expr lambda) {
  // 1 + 2 cos(psi) is the trace; tan^2(psi/2) = (1 - cos(psi))/(1 + cos(psi)).
  const auto trace = [](Expr m) { return entry(m, 0, 0) + entry(m, 1, 1) + entry(m, 2, 2); };
  const Expr cosine = simplified((trace(lambda) - 1) / 2);
  const Expr t = sqrt(simplified((1 - cosine) / (1 + cosine)));
  const Theorem definition =
      book.name("psi", {alpha}, 2 * atan(t), {alpha_positive},
                "From the trace of Lambda, 1 + 2 cos(psi), its angle psi:", "def:psi def:psi-app");
  const Theorem inside = equation(1 + power(t, 2), power(1 + alpha, 2));
  show_angle(book, definition, {inside, root_is(power(1 + alpha, 2), 1 + alpha)}, cosine,
             2 * t / power(1 + alpha, 2));
  know_for_good(book.show("psi_range", "The range of psi:",
                          both({positive(definition), linear(lt(psi(), pi()), {definition})})));
  know_for_good(book.show("half_signs",
                          "so that half of it has a positive sine and a positive cosine:",
                          both({positive(sin(psi() / 2)), positive(cos(psi() / 2))})));
  book.show("trace", "agrees with the trace:",
            equation(trace(Lambda()), 1 + 2 * cos(psi()),
                     {book["cycle.Lambda"], book["rotation.cos_psi"]}));
}
}  // namespace

Theorem root_split(Book& book) {
  return root_is(right(book["rotation.psi"]).arg(1).arg(0).arg(0), sqrt(alpha) * sqrt(2 + alpha));
}

void rotation(Book& book) {
  const Theorem def_lambda = book["cycle.Lambda"];
  const Expr lambda = right(def_lambda);
  book.chapter("rotation", "The rotation", {alpha_positive});
  angle(book, lambda);
  const Theorems rules{root_split(book), def_lambda, book["rotation.cos_psi"],
                       book["rotation.sin_psi"]};

  // The axis, which solves Lambda e = e with a first component 1, and two vectors that complete it.
  const Exprs e{1, real("e_2"), real("e_3")};
  const Exprs axis =
      Exprs{1} + solve(entry_equations(eq(times(lambda, column(e)), column(e))), {e[1], e[2]});
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
  const Theorem frame =
      book.name("R", {alpha}, matrix(3, columns), {alpha_positive},
                "A frame with the axis of Lambda as its third unit vector:", "def:R");
  const Theorems with_frame = Theorems{frame} + rules;
  const Expr w = sqrt(2 + alpha);
  const auto third = column({entry(R(), 0, 2), entry(R(), 1, 2), entry(R(), 2, 2)});
  book.show("axis", "Lambda leaves its axis as it is,",
            equation(times(Lambda(), third), third, with_frame));
  book.show("axis_paper", "which is along the roots of the masses:",
            equation(third, column({1 / w, 1 / w, sqrt(alpha) / w}), with_frame));
  const Theorem quotient = root_is(alpha / (2 * (2 + alpha)), sqrt(alpha) / (sqrt(2) * w));
  const Expr r2 = sqrt(2), q = sqrt(alpha / (2 * (2 + alpha)));
  book.show("R_paper", "eq:R-app", "As the paper writes it:",
            equation(R(),
                     matrix(3, {-1 / r2, -q, 1 / w, 1 / r2, -q, 1 / w, 0, sqrt(2 / (2 + alpha)),
                                sqrt(alpha) / w}),
                     Theorems{quotient, root_is(2 / (2 + alpha), sqrt(2) / w)} + with_frame));
  book.show("R_orthogonal", "The frame is orthogonal:",
            equation(times(transpose(R()), R()), identity(3), with_frame));
  const Theorem turn_3 =
      book.name("lambda_3", {x}, matrix(3, {cos(x), -sin(x), 0, sin(x), cos(x), 0, 0, 0, 1}), {},
                "A rotation about the third axis:", "eq:lambda-3");
  const Theorems turned_rules = Theorems{at(turn_3, {{x, psi()}})} + with_frame;
  book.show("Lambda_in_frame", "eq-app:lambda-R",
            "In this frame Lambda is such a rotation, by psi:",
            equation(times(transpose(R()), times(Lambda(), R())), lambda_3(psi()), turned_rules));
  book.show("Lambda_R", "so that",
            equation(Lambda(), times(times(R(), lambda_3(psi())), transpose(R())), turned_rules));
}
}  // namespace derivation
