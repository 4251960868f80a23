// SPDX-License-Identifier: GPL-2.0-or-later
// Evaluated forms of the ratios, and of a ball that is not lighter than a block.
#include "derivation/evaluators.hpp"

namespace derivation {
void ratio_forms(Names& names) {
  Book& book = names.book;
  book.chapter("evaluators_ratios", "Forms for evaluation: ratios", {le(1, k)});
  for (const auto& [name, half_angle] :
       {std::pair{"alpha_", pi() / (2 * (1 + 2 * k))}, std::pair{"beta_", pi() / (4 * (1 + k))}}) {
    const std::string kind = std::string(name) == "alpha_" ? "magic" : "deficient";
    const auto f = [&](const std::string& part) { return fun(kind + "_" + part, {k}); };
    const Theorem y_is = names.name(kind + "_angle", {k}, half_angle, "With");
    const Theorem sine = names.name(kind + "_sine", {k}, sin(f("angle")));
    const Theorem versed = names.name(kind + "_versed", {k}, 2 * power(f("sine"), 2));
    const Theorem cosine = names.name(kind + "_cosine", {k}, 1 - f("versed"));
    const Theorem definition = book[std::string("ratios.") + name + "k"];
    const Expr whole = definition.conclusion().arg(1).arg(1).arg(0);  // cos(pi/d)
    const Theorem twice = equation(cos(2 * f("angle")), 1 - 2 * power(sin(f("angle")), 2),
                                   angles({cos(2 * f("angle"))}, {f("angle")}));
    const Theorem k_from_0 = linear(le(0, k), {assume(le(1, k))});
    const Theorem angle_is =
        equation(2 * f("angle"), whole.arg(0), {y_is},
                 {positive(2 * k + 1, {k_from_0}), positive(2 * k + 2, {k_from_0}),
                  positive(k + 1, {k_from_0})});
    const Theorem is =
        equation(f("cosine"), whole, {cosine, versed, sine, rewrite(angle_is, twice)});
    know(linear(lt(0, f("cosine")), {is, book[std::string("ratios.") + name + "k_cosine"]}));
    book.show(kind, "", "the ratio is",
              rewrite(turned(is),
                      equation(fun(name, {k}), f("versed") / whole,
                               {definition, linear(eq(f("versed"), 1 - whole), {is, cosine})})));
  }
}
void heavy_ball(Names& names) {
  Book& book = names.book;
  const Expr heavy = le(1, alpha);
  book.chapter("heavy", "A heavy ball", {heavy, V_positive});
  const Theorem is_heavy = assume(heavy);
  const Theorem mass = linear(alpha_positive, {is_heavy});
  const Theorem one = linear(le(1, 1), {});
  const Theorem alpha_1 = book["ratios.alpha_1"];
  const Theorem beta_below = use(discharge(le(1, k), book["ratios.order"]), {{k, 1}}, {one});
  const Expr beta_1 = beta_below.conclusion().arg(0);
  const Theorem once_A = cut(mass, book["ratios.N_A_once"]),
                once_B = cut(mass, book["ratios.N_B_once"]);
  const Theorem counts = both(
      {tautology(eq(N_A(), 1),
                 {once_A, linear(le(alpha_1.conclusion().arg(0), alpha), {alpha_1, is_heavy})}),
       tautology(eq(N_B(), 1),
                 {once_B, linear(le(beta_1, alpha), {beta_below, alpha_1, is_heavy})})});
  book.show("N_A", "", "Both blocks have one collision each, A", part(counts, 0));
  book.show("N_B", "", "and B:", part(counts, 1));
  const Theorem sum = names.name("masses", {alpha}, 1 + alpha, "With");
  know(linear(lt(0, of_alpha("masses")), {sum, positive(1 + alpha, {assume(alpha_positive)})}));
  const Theorem part_of = names.name("per_mass", {alpha}, 1 / of_alpha("masses"));
  const Theorem share = names.name("share", {alpha}, alpha * of_alpha("per_mass"));
  const Theorem less = names.name("lead", {alpha}, 1 - alpha);
  const Expr i = of_alpha("per_mass"), f = of_alpha("share"), D = of_alpha("lead");
  const Theorems rules{share, less, rewrite(sum, part_of)};
  const auto first = [&](const std::string& id, std::size_t which) {
    return part(use(discharge(le(1, n), book[id]), {{n, 1}}, {one}), which);
  };
  const Theorem zero = equation(Expr(1) - 1, 0);
  const Theorem starts = book["cycle.start_vector"];
  Theorems steps{part(starts, 0), part(starts, 1), part(starts, 2)};
  for (const Theorem& t :
       {first("cycle.P", 0), first("cycle.P", 1), first("cycle.Q", 0), first("cycle.Q", 1)})
    steps.push_back(rewrite(zero, t));
  const Theorem p1 = positive(1 + alpha, {assume(alpha_positive)});
  const auto show = [&](const std::string& name, Expr velocity, Expr form) {
    return book.show(name, "", name == "a" ? "the first velocities are" : "and",
                     equation(velocity, V * form, steps + rules, {p1}));
  };
  const Theorems after{show("a", a(1), D * i), show("b", b(1), 4 * f * i), show("c", c(1), 2 * i),
                       show("c_prime", c_prime(1), -2 * D * power(i, 2))};
  const Theorem N_is = linear(eq(N(), 2 * Expr(1)), {part(cut(mass, book["counting.shares"]), 1),
                                                     part(counts, 0), part(counts, 1)});
  const Theorem end =
      cut(mass, use(discharge(le(1, n), discharge(eq(N(), 2 * n), book["terminal.after_Q"])),
                    {{n, 1}}, {one}));
  const Theorem last = tautology(end.conclusion().arg(1), {end, N_is});
  for (const auto& [name, which, velocity] :
       {std::tuple{"a_t", 2U, 0U}, std::tuple{"b_t", 3U, 1U}, std::tuple{"c_t", 4U, 3U}})
    book.show(name, "", which == 2U ? "which are the terminal ones:" : "and",
              chain(part(last, which), cut(mass, after[velocity])));
  book.show("rho", "", "with the fraction of the energy",
            equation(fun("rho", {alpha, V}), 16 * power(f * i, 2),
                     {book["evaluators_end.def_rho"], book["heavy.b_t"]}, {assume(V_positive)}));
}
}  // namespace derivation
