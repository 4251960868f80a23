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
    const Expr whole = right(definition).arg(1).arg(0);  // cos(pi/d)
    const Theorem twice =
        equation(cos(2 * f("angle")), 1 - 2 * power(sin(f("angle")), 2), {}, {f("angle")});
    const Theorem angle_is = equation(2 * f("angle"), whole.arg(0), {y_is, assume(le(1, k))});
    const Theorem is =
        equation(f("cosine"), whole, {cosine, versed, sine, rewrite(angle_is, twice)});
    know(linear(lt(0, f("cosine")), {is, book[std::string("ratios.") + name + "k_cosine"]}));
    book.show(kind, "the ratio is",
              rewrite(turned(is),
                      equation(fun(name, {k}), f("versed") / whole,
                               {definition, linear(eq(f("versed"), 1 - whole), {is, cosine})})));
  }
}
void heavy_ball(Names& names) {
  Book& book = names.book;
  const Expr heavy = le(1, alpha);
  book.chapter("heavy", "A heavy ball", {heavy, V_positive});
  const Theorem is_heavy = assume(heavy), mass = linear(alpha_positive, {is_heavy});
  const Theorem alpha_1 = book["ratios.alpha_1"], beta_below = at(book["ratios.order"], {{k, 1}});
  const auto once = [&](const char* id, const Theorems& facts) {
    const Theorem t = cut(mass, book[id]);  // N = 1 if and only if the first ratio is <= alpha
    return tautology(left(t), {t, linear(right(t), facts + Theorems{alpha_1, is_heavy})});
  };
  const Theorem counts =
      both({book.show("N_A", "Both blocks have one collision each, A", once("ratios.N_A_once", {})),
            book.show("N_B", "and B:", once("ratios.N_B_once", {beta_below}))});
  const Theorem sum = names.name("masses", {alpha}, 1 + alpha, "With");
  know(positive(sum));
  const Theorem part_of = names.name("per_mass", {alpha}, 1 / of_alpha("masses"));
  const Theorem share = names.name("share", {alpha}, alpha * of_alpha("per_mass"));
  const Theorem less = names.name("lead", {alpha}, 1 - alpha);
  const Expr i = of_alpha("per_mass"), f = of_alpha("share"), D = of_alpha("lead");
  Theorems steps{book["cycle.start_vector"]};
  const Theorem zero = equation(Expr(1) - 1, 0);
  for (const char* id : {"cycle.P", "cycle.Q"})
    steps = steps + parts({rewrite(zero, at(book[id], {{n, 1}}))});
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
  book.show("rho", "with the fraction of the energy",
            equation(fun("rho", {alpha, V}), 16 * power(f * i, 2),
                     {book["evaluators_end.def_rho"], book["heavy.b_t"]}));
}
}  // namespace derivation
