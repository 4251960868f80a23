// SPDX-License-Identifier: GPL-2.0-or-later
// The forms that are evaluated: from tan(psi/4) and cot(psi/2), without cancellation or overflow.
#include "derivation/evaluators.hpp"

namespace derivation {
namespace {
Angle angle(Book& book) {
  const Names names{book, {alpha}, {alpha_positive}};
  const Theorem above = names.name("above", 2 + alpha, "With");
  know_for_good(positive(above));
  const Theorem w = names.name("w", 1 / sqrt(alpha * of_alpha("above")));
  const Theorem z = rewrite(above, names.name("z", alpha / of_alpha("above")));
  const Theorem t = names.name("t", alpha * of_alpha("w"));
  const Theorem half_h = names.name("half_h", atan(of_alpha("t")));
  const Theorem under_root = rewrite(above, w);
  const Expr T = of_alpha("t"), q = of_alpha("half_h");
  const Theorem w_positive = positive(under_root);
  know_for_good(linear(lt(0, T), {t, times(w_positive, alpha)}));
  const Theorem t_squared =
      book.show("t_squared", "t^2 is", equation(power(T, 2), of_alpha("z"), {t, under_root, z}));
  const Theorem T_is = root_is(alpha / (2 + alpha), T, {t_squared, z});
  const Theorem whole = rewrite(turned(half_h), rewrite(T_is, book["table.quarter_psi"]));
  const Theorem light = assume(le(alpha, 1));
  book.show(
      "z_at_most", "a third at most for a ball that is not heavier than a block:",
      linear(le(of_alpha("z"), rational(1, 3)), {z, times(light, rational(2, 3) / (2 + alpha))}));
  book.show("psi", "psi is four times the arctangent of t:", whole);
  const Theorem quarters = book["power.quarter"];  // cos^2 and cos sin
  const Theorem tangent = cancel(eq(T, sin(psi() / 4) / cos(psi() / 4)), {positive(cos(psi() / 4))},
                                 {t, under_root, quarters});
  return {
      linear(eq(q, psi() / 4), {whole}),
      tangent,
      linear(le(T, of_alpha("w")), {t, times(light, w_positive)}),
      {equation(of_alpha("w"), T / alpha, {t}), tangent, part(quarters, 1), book["power.V_CM"]}};
}

/// Both velocities after P_n and both after Q_n, from one sine and one cosine.
void velocities(Book& book, const Angle& a) {
  const Names f{book, {alpha, n}, {alpha_positive, n_from_0}};
  const Theorem def_x = f.name("phase", 2 * of_alpha("half_h") * n, "With");
  const auto at_angle = [&](const std::string& name, Expr value) {
    return rewrite(a.quarter, rewrite(def_x, f.name(name, value)));
  };
  const Theorems parts{
      at_angle("sine", sin(f("phase"))),           at_angle("cosine", cos(f("phase"))),
      f.name("t_sine", of_alpha("t") * f("sine")), f.name("w_sine", of_alpha("w") * f("sine")),
      f.name("plus", f("cosine") + f("t_sine")),   f.name("minus", f("cosine") - f("t_sine")),
      f.name("along", f("cosine") + f("w_sine"))};
  book.show("t_sine_at_most", "where for a ball that is not heavier than a block",
            linear(le(f("t_sine"), f("w_sine")),
                   {parts[2], parts[3], times(a.t_small, assume(le(0, f("sine"))))}));
  const auto show = [&](const std::string& name, const std::string& id, Expr velocity, Expr form) {
    book.show(name, name == "a" ? "the velocities are" : "and",
              equation(velocity, V * form, Theorems{book["power." + id]} + parts + a.rules,
                       {n * psi() / 2, psi() / 4}));
  };
  show("a", "a_product", derivation::a(n), f("plus") * f("minus"));
  show("b", "b_product", b(n), 2 * f("along") * f("t_sine"));
  show("c", "c_product", c(n), 2 * f("plus") * f("w_sine"));
  show("c_prime", "c_prime_product", c_prime(n), -2 * f("minus") * f("w_sine"));
}
/// alpha_k and beta_k from the sine of half of their angle.
void ratio_forms(Book& book) {
  const Names names{book, {k}, {le(1, k)}};
  book.chapter("evaluators_ratios", "Forms for evaluation: ratios", {le(1, k)});
  for (const auto& [name, half_angle] :
       {std::pair{"alpha_", pi() / (2 * (1 + 2 * k))}, std::pair{"beta_", pi() / (4 * (1 + k))}}) {
    const std::string kind = std::string(name) == "alpha_" ? "magic" : "deficient";
    const auto f = [&](const std::string& part) { return names(kind + "_" + part); };
    const Theorem y_is = names.name(kind + "_angle", half_angle, "With");
    const Theorem sine = names.name(kind + "_sine", sin(f("angle")));
    const Theorem versed = names.name(kind + "_versed", 2 * power(f("sine"), 2));
    const Theorem cosine = names.name(kind + "_cosine", 1 - f("versed"));
    const Theorem definition = book[std::string("ratios.") + name + "k"];
    const Expr whole = right(definition).arg(1).arg(0);  // cos(pi/d)
    const Theorem twice =
        equation(cos(2 * f("angle")), 1 - 2 * power(sin(f("angle")), 2), {}, {f("angle")});
    const Theorem angle_is = equation(2 * f("angle"), whole.arg(0), {y_is});
    const Theorem is =
        equation(f("cosine"), whole, {cosine, versed, sine, rewrite(angle_is, twice)});
    know(linear(lt(0, f("cosine")), {is}));
    book.show(kind, "the ratio is",
              rewrite(turned(is),
                      equation(fun(name, {k}), f("versed") / whole,
                               {definition, linear(eq(f("versed"), 1 - whole), {is, cosine})})));
  }
}
/// A ball that is not lighter than a block has one collision with each: rational velocities.
void heavy_ball(Book& book) {
  const Names names{book, {alpha}, {alpha_positive}};
  const Expr heavy = le(1, alpha);
  book.chapter("heavy", "A heavy ball", {heavy, V_positive});
  const Theorem is_heavy = assume(heavy), mass = linear(alpha_positive, {is_heavy});
  const Theorem alpha_1 = book["ratios.alpha_1"], beta_below = at(book["ratios.order"], {{k, 1}});
  const auto once = [&](const char* id, const Theorems& facts) {
    const Theorem t = cut(mass, book[id]);  // N = 1 if and only if the first ratio is <= alpha
    return tautology(left(t), {t, linear(right(t), facts + Theorems{alpha_1})});
  };
  const Theorem counts =
      both({book.show("N_A", "Both blocks have one collision each, A", once("ratios.N_A_once", {})),
            book.show("N_B", "and B:", once("ratios.N_B_once", {beta_below}))});
  const Theorem sum = names.name("masses", 1 + alpha, "With");
  know(positive(sum));
  const Theorem part_of = names.name("per_mass", 1 / of_alpha("masses"));
  const Theorem share = names.name("share", alpha * of_alpha("per_mass"));
  const Theorem less = names.name("lead", 1 - alpha);
  const Expr i = of_alpha("per_mass"), f = of_alpha("share"), D = of_alpha("lead");
  Theorems steps{book["cycle.start_vector"]};
  for (const char* id : {"cycle.P", "cycle.Q"})
    steps = steps + parts({rewrite(equation(Expr(1) - 1, 0), at(book[id], {{n, 1}}))});
  const Theorems rules{share, less, rewrite(sum, part_of)};
  const auto show = [&](const std::string& name, Expr velocity, Expr form) {
    return book.show(name, name == "a" ? "the first velocities are" : "and",
                     equation(velocity, V * form, steps + rules));
  };
  const Theorems after{show("a", a(1), D * i), show("b", b(1), 4 * f * i), show("c", c(1), 2 * i),
                       show("c_prime", c_prime(1), -2 * D * power(i, 2))};
  const Theorem N_is = linear(eq(N(), 2 * Expr(1)), {cut(mass, book["counting.shares"]), counts});
  const Theorem end = cut(mass, cut(N_is, at(book["terminal.after_Q"], {{n, 1}}, {N_is})));
  for (const auto& [name, which, velocity] :
       {std::tuple{"a_t", 2U, 0U}, std::tuple{"b_t", 3U, 1U}, std::tuple{"c_t", 4U, 3U}})
    book.show(name, which == 2U ? "which are the terminal ones:" : "and",
              chain(part(end, which), cut(mass, after[velocity])));
}
}  // namespace

void evaluators(Book& book) {
  book.chapter("evaluators", "Forms for evaluation", {alpha_positive, n_from_0});
  const Angle a = angle(book);
  velocities(book, a);
  terminal_forms(book, a);
  ratio_forms(book);
  heavy_ball(book);
  collision_forms(book, a);
}
}  // namespace derivation
