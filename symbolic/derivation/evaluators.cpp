// SPDX-License-Identifier: GPL-2.0-or-later
// The forms that are evaluated: from tan(psi/4) and cot(psi/2), without cancellation or overflow.
#include "derivation/evaluators.hpp"

namespace derivation {
namespace {
const Expr from_0 = le(0, n);

Angle angle(Names& names) {
  Book& book = names.book;
  const Theorem mass = assume(alpha_positive);
  const Theorem p1 = positive(1 + alpha, {mass}), p2 = positive(2 + alpha, {mass});
  const Theorem above = names.name("above", {alpha}, 2 + alpha, "With");
  know(linear(lt(0, of_alpha("above")), {above, p2}));
  const Theorem w = names.name("w", {alpha}, 1 / sqrt(alpha * of_alpha("above")));
  const Theorem z = rewrite(above, names.name("z", {alpha}, alpha / of_alpha("above")));
  const Theorem t = names.name("t", {alpha}, alpha * of_alpha("w"));
  const Theorem half_h = names.name("half_h", {alpha}, atan(of_alpha("t")));
  const Theorem root = root_squared(positive(alpha * (2 + alpha), {mass, p2}));
  const Theorem under_root = rewrite(above, w);
  const Theorem w_positive = linear(
      lt(0, of_alpha("w")), {under_root, positive(1 / sqrt(alpha * (2 + alpha)), {mass, p2})});
  const Theorem t_positive = linear(lt(0, of_alpha("t")), {t, times(mass, w_positive)});
  const Theorem t_squared =
      book.show("t_squared", "", "t^2 is",
                equation(power(of_alpha("t"), 2), of_alpha("z"), {t, under_root, z, root},
                         {p2, positive(sqrt(alpha * (2 + alpha)), {mass, p2})}));
  // cos(2 atan t) = (1 - t^2)/(1 + t^2) = 1/(1 + alpha) = cos(psi/2)
  const Expr T = of_alpha("t"), q = of_alpha("half_h");
  const Theorem one_more = positive(1 + power(T, 2), {t_positive});
  const Theorems values{rewrite(turned(half_h), use("cos atan", {{x, T}})),
                        rewrite(turned(half_h), use("sin atan", {{x, T}})), root_squared(one_more)};
  const Theorem cos_twice =
      equation(cos(2 * q), 1 / (1 + alpha),
               angles({cos(2 * q)}, {q}, false) + values + Theorems{t_squared, z},
               {p1, p2, positive(sqrt(1 + power(T, 2)), {t_positive})});
  const Theorem q_positive = linear(lt(0, q), {half_h, positive(atan(T), {t_positive})});
  const Theorem q_below = linear(lt(2 * q, pi()), {half_h, part(use("atan range", {{x, T}}), 1)});
  const Theorem psi_from = part(book["rotation.psi_range"], 0),
                psi_to = part(book["rotation.psi_range"], 1);
  const Theorem same =
      same_angle(chain(cos_twice, turned(book["rotation.cos_half_psi"])),
                 linear(lt(0, 2 * q), {q_positive}), q_below, linear(lt(0, psi() / 2), {psi_from}),
                 linear(lt(psi() / 2, pi()), {psi_from, psi_to}));
  const Theorem is_quarter = linear(eq(q, psi() / 4), {same});
  const Theorem light = assume(le(alpha, 1));
  Certificate third;  // 1/3 - alpha/(2 + alpha) = 2 (1 - alpha)/(3 (2 + alpha))
  third.multipliers = {p2};
  third.nonzero = {p2};
  third.equations = {{2 + alpha, z}};
  third.products = {{rational(2, 3).value(), {light}, {}}};
  book.show("z_at_most", "", "a third at most for a ball that is not heavier than a block:",
            arithmetic(le(of_alpha("z"), rational(1, 3)), third));
  book.show("psi", "", "psi is four times the arctangent of t:", linear(eq(psi(), 4 * q), {same}));
  const Theorem cosine = rewrite(is_quarter, values[0]);
  const Theorem sine = rewrite(is_quarter, values[1]);
  const Theorem cos_positive =
      linear(lt(0, cos(psi() / 4)), {cosine, positive(1 / sqrt(1 + power(T, 2)), {t_positive})});
  const Theorem tangent = equation(T, sin(psi() / 4) / cos(psi() / 4), {sine, cosine},
                                   {cos_positive, positive(sqrt(1 + power(T, 2)), {t_positive})});
  Certificate smaller;  // w - t = (1 - alpha) w
  smaller.equations = {{1, t}};
  smaller.products = {{1, {light, w_positive}, {}}};
  return {is_quarter,
          tangent,
          t,
          equation(of_alpha("w"), T / alpha, {t}, {mass}),
          w_positive,
          cos_positive,
          arithmetic(le(T, of_alpha("w")), smaller)};
}

/// Both velocities after P_n and both after Q_n, from one sine and one cosine.
void velocities(Names& names, const Angle& a) {
  Book& book = names.book;
  const Exprs both_inputs{alpha, n};
  const Theorem def_x = names.name("phase", both_inputs, 2 * of_alpha("half_h") * n, "With");
  const auto at_angle = [&](const std::string& name, Expr value) {
    const Theorem t = names.name(name, both_inputs, value);
    return rewrite(a.quarter, rewrite(def_x, t));
  };
  const auto f = of_both;
  const Theorems parts{at_angle("sine", sin(f("phase"))),
                       at_angle("cosine", cos(f("phase"))),
                       names.name("t_sine", both_inputs, of_alpha("t") * f("sine")),
                       names.name("w_sine", both_inputs, of_alpha("w") * f("sine")),
                       names.name("plus", both_inputs, f("cosine") + f("t_sine")),
                       names.name("minus", both_inputs, f("cosine") - f("t_sine")),
                       names.name("along", both_inputs, f("cosine") + f("w_sine"))};
  book.show("t_sine_at_most", "", "where for a ball that is not heavier than a block",
            under({alpha_positive, from_0}, larger(a.t_small, f("sine"), parts[2], parts[3])));
  const Prover prover(book, a);
  const Exprs bases{n * psi() / 2, psi() / 4};
  const auto show = [&](const std::string& name, const std::string& id, Expr velocity, Expr form,
                        const Theorems& factors) {
    const Theorem t =
        prover.equal(velocity, V * form, Theorems{book["power." + id]} + parts, bases, factors);
    book.show(name, "", name == "a" ? "the velocities are" : "and", t);
  };
  const Theorems cosines{a.cos_positive, a.cos_positive};
  show("a", "a_product", derivation::a(n), f("plus") * f("minus"), cosines);
  show("b", "b_product", b(n), 2 * f("along") * f("t_sine"), cosines);
  show("c", "c_product", c(n), 2 * f("plus") * f("w_sine"), cosines);
  show("c_prime", "c_prime_product", c_prime(n), -2 * f("minus") * f("w_sine"), cosines);
}
}  // namespace

Theorem larger(const Theorem& t_small, Expr factor, const Theorem& t_product,
               const Theorem& w_product) {
  Certificate c;
  c.equations = {{1, t_product}, {-1, w_product}};
  c.products = {{1, {t_small, assume(le(0, factor))}, {}}};
  return arithmetic(le(t_product.conclusion().arg(0), w_product.conclusion().arg(0)), c);
}

void evaluators(Book& book) {
  book.chapter("evaluators", "Forms for evaluation", {alpha_positive, from_0});
  Names names(book);
  const Angle a = angle(names);
  velocities(names, a);
  terminal_forms(names, a);
  ratio_forms(names);
  heavy_ball(names);
}
}  // namespace derivation
