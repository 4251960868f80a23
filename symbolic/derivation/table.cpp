// The rest of the paper's table: roots in one piece, and tangents.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr tan(Expr t) { return fun("tan", {t}); }
const Expr s = sqrt(alpha), root = sqrt(alpha * (2 + alpha));

/// The quarter of psi: cosine and sine as roots, psi as four times an arctangent, its tangent.
Theorem quarter(Book& book) {
  const Expr q = psi() / 4, t = sqrt(alpha / (2 + alpha));
  const Theorem cosine_squared = part(book["power.quarter"], 1);
  const Theorems squares = angles({}, {q}) + Theorems{cosine_squared};
  book.show("cos_quarter_psi", "table:trig", "The quarter of psi:",
            turned(root_is((2 + alpha) / (2 * (1 + alpha)), cos(q), {cosine_squared})));
  book.show("sin_quarter_psi", "table:trig", "and",
            turned(root_is(alpha / (2 * (1 + alpha)), sin(q), squares)));
  const Theorem hypotenuse = root_is(1 + power(t, 2), 1 / cos(q), squares);
  const Theorem same =
      same_angle(equation(cos(q), cos(atan(t)), {rewrite(hypotenuse, at("cos atan", {{x, t}}))}),
                 {positive(atan(t))});
  book.show("quarter_psi", "so that", linear(eq(psi(), 4 * atan(t)), {same}));
  return turned(root_is(alpha / (2 + alpha), sin(q) / cos(q), squares));
}
}  // namespace

void table(Book& book) {
  book.chapter("table", "Table of sines, cosines and tangents", {alpha_positive});
  const Theorem sine_half = book["ball.sin_half_theta"];
  book.show("sin_half_theta", "table:trig", "Half of theta, in one root:",
            chain(sine_half, turned(root_is(alpha / (1 + alpha), s / sqrt(1 + alpha)))));
  const Theorem of_quarter = quarter(book);

  const Theorem is = book.name("tan", {x}, sin(x) / cos(x), {neq(cos(x), 0)}, "The tangent:");
  const auto show = [&](const std::string& name, Expr angle, Expr value, const Theorems& facts) {
    book.show("tan_" + name, "table:trig", name == "half_theta" ? "Their tangents:" : "and",
              equation(tan(angle), value, Theorems{at(is, {{x, angle}})} + facts));
  };
  const Theorem cos_half = book["ball.cos_half_theta"];
  know(positive(cos_half));
  show("half_theta", theta() / 2, s, {sine_half, cos_half});
  show("quarter_psi", psi() / 4, sqrt(alpha / (2 + alpha)), {turned(of_quarter)});
  show("half_psi", psi() / 2, root, {book["rotation.sin_half_psi"], book["rotation.cos_half_psi"]});
  // cos = numerator/d is not 0 where the numerator is not.
  const auto show_where = [&](const std::string& name, Expr angle, Expr numerator, Expr d,
                              Expr above, const Theorems& values) {
    const Theorem moves = assume(neq(numerator, 0));
    const Theorem none = given(eq(cos(angle), 0), [&](const Theorem& is_0) {
      return linear(eq(numerator, 0), {rewrite(is_0, equation(d * cos(angle), numerator, values))});
    });
    const Theorem divisor = tautology(neq(cos(angle), 0), {none, moves});
    know(divisor);
    show(name, angle, above / numerator, values + Theorems{moves, divisor});
  };
  show_where("theta", theta(), 1 - alpha, 1 + alpha, 2 * s,
             {book["ball.cos_theta"], book["ball.sin_theta"]});
  show_where("psi", psi(), 1 - 2 * alpha - power(alpha, 2), power(1 + alpha, 2), 2 * root,
             {book["rotation.cos_psi"], book["rotation.sin_psi"]});
}
}  // namespace derivation
