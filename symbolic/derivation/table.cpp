// SPDX-License-Identifier: GPL-2.0-or-later
// The rest of the paper's table: roots in one piece, and tangents.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
Expr tan(Expr t) { return fun("tan", {t}); }
const Expr s = sqrt(alpha), root = sqrt(alpha * (2 + alpha));

/// numerator != 0 |- not cos(angle) = 0, from cos(angle) = numerator/d
Theorem cosine_not_0(Expr numerator, const Theorem& cosine, Expr d, const Theorem& p1) {
  const Expr value = cosine.conclusion().arg(0);
  const Theorem product = equation(d * value, numerator, {cosine}, {p1});
  const Theorem zero = assume(eq(value, 0));
  return tautology(neq(value, 0), {discharge(zero.conclusion(),
                                             linear(eq(numerator, 0), {rewrite(zero, product)})),
                                   assume(neq(numerator, 0))});
}

/// The quarter of psi: cosine and sine as roots, psi as four times an arctangent.
Theorems quarter(Book& book, const Theorem& p1, const Theorem& p2) {
  const Expr q = psi() / 4;
  const Theorem sine_positive = part(book["power.quarter"], 0);
  const Theorem cosine_squared = part(book["power.quarter"], 1);
  const Theorem from = linear(lt(0, q), {part(book["rotation.psi_range"], 0)});
  const Theorem below = linear(lt(q, pi() / 2), {from, part(book["rotation.psi_range"], 1)});
  const Theorem positive_cosine = cosine_positive(from, below);
  know(positive_cosine);
  book.show("quarter_cosine", "", "A quarter of psi has a positive cosine,", positive_cosine);
  const Theorem sine_squared =
      linear(eq(power(sin(q), 2), 1 - power(cos(q), 2)), {use("circle", {{x, q}})});
  const Theorem cosine = book.show("cos_quarter_psi", "table:trig", "that is,",
                                   turned(root_is((2 + alpha) / (2 * (1 + alpha)), cos(q),
                                                  positive_cosine, {cosine_squared}, {p1})));
  book.show("sin_quarter_psi", "table:trig", "and",
            turned(root_is(alpha / (2 * (1 + alpha)), sin(q), sine_positive,
                           {sine_squared, cosine_squared}, {p1})));
  const Theorem tangent = root_is(alpha / (2 + alpha), sin(q) / cos(q),
                                  positive(sin(q) / cos(q), {sine_positive, positive_cosine}),
                                  {sine_squared, cosine_squared}, {positive_cosine, p1, p2});
  const Expr t = sqrt(alpha / (2 + alpha));
  const Theorem t_positive = positive(t, {assume(alpha_positive)});
  const Theorem t_squared = root_squared(positive(alpha / (2 + alpha), {assume(alpha_positive)}));
  const Theorem hypotenuse =
      root_is(1 + power(t, 2), 1 / cos(q), positive(1 / cos(q), {positive_cosine}),
              {cosine_squared, t_squared}, {positive_cosine, p1, p2});
  const Theorem same =
      same_angle(equation(cos(q), cos(atan(t)), {rewrite(hypotenuse, use("cos atan", {{x, t}}))},
                          {positive_cosine, positive(1 / cos(q), {positive_cosine})}),
                 from, linear(lt(q, pi()), {from, below}), positive(atan(t), {t_positive}),
                 linear(lt(atan(t), pi()), {part(use("atan range", {{x, t}}), 1), positive(pi())}));
  book.show("quarter_psi", "", "so that", linear(eq(psi(), 4 * atan(t)), {same}));
  return {turned(tangent), positive_cosine};
}
}  // namespace

void table(Book& book) {
  book.chapter("table", "Table of sines, cosines and tangents", {alpha_positive});
  const Theorem mass = assume(alpha_positive);
  const Theorem p1 = positive(1 + alpha, {mass}), p2 = positive(2 + alpha, {mass});
  const Theorem root_1 = positive(sqrt(1 + alpha), {p1});
  const Theorem sine_half = book["ball.sin_half_theta"];
  const Theorem sine_value = positive(s / sqrt(1 + alpha), {mass});
  book.show(
      "sin_half_theta", "table:trig", "Half of theta, in one root:",
      chain(sine_half, turned(root_is(alpha / (1 + alpha), s / sqrt(1 + alpha), sine_value,
                                      {root_squared(mass), root_squared(p1)}, {p1, root_1}))));
  const Theorems of_quarter = quarter(book, p1, p2);

  const Theorem definition = define("tan", {x}, sin(x) / cos(x), 0);
  restrict_domain("tan", {x}, neq(cos(x), 0));
  book.show("tan", "", "The tangent:", under({neq(cos(x), 0)}, definition));
  const auto show = [&](const std::string& name, Expr angle, Expr value, const Theorem& not_0,
                        const Theorems& rules, const Theorems& divisors) {
    know(not_0);
    book.show("tan_" + name, "table:trig", name == "half_theta" ? "Their tangents:" : "and",
              equation(tan(angle), value, Theorems{instantiate(definition, {{x, angle}})} + rules,
                       Theorems{not_0} + divisors));
  };
  const Theorem cos_half = book["ball.cos_half_theta"];
  const Theorem half_positive =
      linear(lt(0, cos(theta() / 2)), {cos_half, positive(1 / sqrt(1 + alpha), {root_1})});
  show("half_theta", theta() / 2, s, half_positive, {sine_half, cos_half}, {root_1});
  show("quarter_psi", psi() / 4, sqrt(alpha / (2 + alpha)), of_quarter[1], {turned(of_quarter[0])},
       {});
  const Theorem psi_half = book["rotation.cos_half_psi"];
  show("half_psi", psi() / 2, root, part(book["rotation.half_signs"], 1),
       {book["rotation.sin_half_psi"], psi_half}, {p1});
  const auto show_where = [&](const std::string& name, Expr angle, Expr numerator, Expr d,
                              Expr above, const Theorems& values) {
    show(name, angle, above / numerator, cosine_not_0(numerator, values[0], d, p1), values,
         {assume(neq(numerator, 0)), p1});
  };
  show_where("theta", theta(), 1 - alpha, 1 + alpha, 2 * s,
             {book["ball.cos_theta"], book["ball.sin_theta"]});
  show_where("psi", psi(), 1 - 2 * alpha - power(alpha, 2), power(1 + alpha, 2), 2 * root,
             {book["rotation.cos_psi"], book["rotation.sin_psi"]});
}
}  // namespace derivation
