// SPDX-License-Identifier: GPL-2.0-or-later
// Evaluated forms of the terminal velocities and counts.
#include "derivation/evaluators.hpp"

namespace derivation {
namespace {
const Expr from_0 = le(0, n);

/// |- 0 <= x implies sqrt(x^2) = x, and |- x <= 0 implies sqrt(x^2) = -x
std::pair<Theorem, Theorem> root_of_square() {
  const Expr s = sqrt(power(x, 2));
  const Theorem square = not_negative(power(x, 2));
  const Theorem squared = root_squared(square);
  const Theorem s_from_0 = use("root not negative", {{x, power(x, 2)}}, {square});
  const auto with_sign = [&](Expr value, const Theorem& value_from_0) {  // s = value, value^2 = x^2
    const Theorem differ = assume(neq(s + value, 0));
    Certificate c;  // (s + value)(value - s) = x^2 - s^2
    c.multipliers = {differ};
    c.equations = {{-1, squared}};
    const Theorem other = arithmetic(eq(s, value), c);
    const Theorem none = assume(eq(s + value, 0));
    const Theorem both_0 = linear(eq(s, value), {none, s_from_0, value_from_0});
    return discharge(value_from_0.hypotheses()[0],
                     tautology(eq(s, value), {discharge(differ.conclusion(), other),
                                              discharge(none.conclusion(), both_0)}));
  };
  const Theorem above = assume(le(0, x)), below = assume(le(x, 0));
  return {with_sign(x, above), with_sign(-x, linear(le(0, -x), {below}))};
}
}  // namespace

void terminal_forms(Names& names, const Angle& a) {
  Book& book = names.book;
  book.chapter("evaluators_end", "Forms for evaluation: terminal velocities",
               {alpha_positive, V_positive});
  const Exprs inputs{alpha, V};
  const auto f = [&](const std::string& name) { return fun(name, inputs); };
  const Theorem h = names.name("h", {alpha}, 2 * of_alpha("half_h"), "With");
  const Theorem psi_is = linear(eq(psi(), 2 * of_alpha("h")), {h, a.quarter});
  const Theorem h_positive =
      linear(lt(0, of_alpha("h")), {psi_is, part(book["rotation.psi_range"], 0)});
  know(h_positive);
  const auto count = [&](const std::string& name, Expr shift) {
    const Theorem quotient = equation(pi() / psi(), pi() / (2 * of_alpha("h")),
                                      {linear(eq(of_alpha("h"), psi() / 2), {psi_is})},
                                      {part(book["rotation.psi_range"], 0), h_positive});
    book.show(name, "", name == "N_A" ? "the counts are" : "and",
              restate(eq(f(name), ceil(pi() / (2 * of_alpha("h")) - shift)),
                      rewrite(quotient, book["counting." + name])));
  };
  count("N_A", rational(1, 2));
  count("N_B", 1);

  const Expr angle = N_A() * psi() / 2;
  const Expr r = pi() / 2 - angle;
  const Theorem def_rest =
      names.name("rest", inputs, sqrt(power(pi() / 2 - of_alpha("h") * N_A(), 2)),
                 "What is left of a quarter turn:");
  const Theorem rest_is =
      restate(eq(f("rest"), sqrt(power(r, 2))),
              rewrite(linear(eq(of_alpha("h"), psi() / 2), {psi_is}), def_rest));
  const Theorem def_sine = names.name("rest_sine", inputs, sin(f("rest")));
  const Theorem def_cosine = names.name("rest_cosine", inputs, cos(f("rest")));
  const Theorems parts{names.name("t_cosine", inputs, of_alpha("t") * f("rest_cosine")),
                       names.name("w_cosine", inputs, of_alpha("w") * f("rest_cosine")),
                       names.name("t_plus", inputs, f("t_cosine") + f("rest_sine")),
                       names.name("t_minus", inputs, f("t_cosine") - f("rest_sine")),
                       names.name("w_plus", inputs, f("w_cosine") + f("rest_sine")),
                       names.name("b_form", inputs, 2 * f("w_plus") * f("t_cosine"))};
  const Prover prover(book, a);
  const Theorem N_A_from_1 = part(book["counting.at_least"], 0);
  const Theorem psi_positive = part(book["rotation.psi_range"], 0);
  const Theorem z_rounded = use("ceiling", {{x, 2 * pi() / psi()}});
  const Theorem per = equation(psi() * (2 * pi() / psi()), 2 * pi(), {}, {psi_positive});
  const auto roots = root_of_square();
  const Theorem root_above = roots.first, root_below = roots.second;

  // Q_n last: r > 0; P_n last: r <= 0.
  const auto in_case = [&](bool Q_last) {
    const Expr steps = Q_last ? 2 * n : 2 * n - 1;
    const Theorem N_is = assume(eq(N(), substitute(steps, {{n, N_A()}})));
    const Theorem end =
        use(discharge(le(1, n), discharge(eq(N(), steps),
                                          book[Q_last ? "terminal.after_Q" : "terminal.after_P"])),
            {{n, N_A()}}, {N_A_from_1});
    const Theorem facts = tautology(
        end.conclusion().op() == Op::Imp ? end.conclusion().arg(1) : end.conclusion(), {end, N_is});
    const Theorem bound = Q_last ? linear(lt(0, 2 * pi() / psi() - 2 * N_A()),
                                          {N_is, book["counting.N"], part(z_rounded, 1)})
                                 : linear(le(0, 2 * N_A() - 2 * pi() / psi()),
                                          {N_is, book["counting.N"], part(z_rounded, 0)});
    const Theorem sign = linear(Q_last ? le(0, r) : le(r, 0), {times(bound, psi_positive), per});
    const Theorem size = chain(rest_is, use(Q_last ? root_above : root_below, {{x, r}}, {sign}));
    const Theorems turned_by{use("cos minus", {{x, angle}}),
                             use("sin minus", {{x, angle}}),
                             use("cos minus", {{x, r}}),
                             use("sin minus", {{x, r}}),
                             use("cos sum", {{x, pi() / 2}, {y, -angle}}),
                             use("sin sum", {{x, pi() / 2}, {y, -angle}}),
                             axiom("cos pi/2"),
                             axiom("sin pi/2")};
    const Theorem sine = equation(f("rest_sine"), Q_last ? cos(angle) : -cos(angle),
                                  Theorems{rewrite(size, def_sine)} + turned_by);
    const Theorem cosine =
        equation(f("rest_cosine"), sin(angle), Theorems{rewrite(size, def_cosine)} + turned_by);
    const Theorem before = linear(le(0, N_A() - 1), {N_A_from_1});
    const Theorem here = linear(le(0, N_A()), {N_A_from_1});
    const auto product = [&](const std::string& id, Expr index, const Theorem& index_from_0) {
      return use(discharge(from_0, book["power." + id]), {{n, index}}, {index_from_0});
    };
    const auto value = [&](std::size_t i, const Theorem& form, Expr goal) {
      const Theorem is = part(facts, i);
      return prover.equal(is.conclusion().arg(0), goal,
                          Theorems{is, form} + parts + Theorems{sine, cosine}, {angle, psi() / 4},
                          {a.cos_positive, a.cos_positive});
    };
    const Theorem velocities = both(
        {value(2, product("a_product", N_A(), here), V * (-f("t_minus") * f("t_plus"))),
         value(3,
               Q_last ? product("b_product", N_A(), here) : product("b_product", N_A() - 1, before),
               V * f("b_form")),
         value(4,
               Q_last ? product("c_prime_product", N_A(), here) : product("c_product", N_A(), here),
               V * (2 * f("t_minus") * f("w_cosine")))});
    return discharge(N_is.conclusion(), velocities);
  };
  const Theorem Q = in_case(true);
  const Theorem P = in_case(false);
  book.show("terminal", "", "The terminal velocities are, whichever collision is the last,",
            tautology(Q.conclusion().arg(1), {Q, P, book["terminal.last"]}));
  const Theorem transmitted = define("rho", inputs, power(fun("b_t", inputs) / V, 2));
  restrict_domain("rho", inputs, logic_and({alpha_positive, V_positive}));
  book.show("def_rho", "", "and B has of the energy the fraction",
            under({alpha_positive, V_positive}, transmitted));
  book.show(
      "rho", "", "that is,",
      equation(f("rho"), power(f("b_form"), 2),
               {transmitted, part(book["evaluators_end.terminal"], 1)}, {assume(V_positive)}));

  // |r| <= h/2, so sin|r| <= tan(h/2) cos(r).
  const Expr half_h = of_alpha("h") / 2;
  const Theorem rounded = use("ceiling", {{x, pi() / psi() - rational(1, 2)}});
  const Theorem per_half = equation(psi() * (pi() / psi()), pi(), {}, {psi_positive});
  const auto scaled_by_psi = [&](Expr goal, const Theorem& relation) {
    return linear(goal, {times(relation, psi_positive), per_half, psi_is});
  };
  const Theorem number = book["counting.N_A"];
  const Theorem r_up = scaled_by_psi(
      le(r, half_h),
      linear(le(0, N_A() + rational(1, 2) - pi() / psi()), {part(rounded, 0), number}));
  const Theorem r_down = scaled_by_psi(
      le(-r, half_h),
      linear(le(0, pi() / psi() + rational(1, 2) - N_A()), {part(rounded, 1), number}));
  const auto with_sign = [&](const Theorem& root, Expr sign, const Theorem& bound,
                             const Theorem& given) {
    const Theorem is = chain(rest_is, use(root, {{x, r}}, {given}));
    const Theorem from = linear(le(0, f("rest")), {is, given});
    return discharge(sign, both({from, linear(le(f("rest"), half_h), {is, bound})}));
  };
  const Theorem above = assume(le(0, r)), below = assume(lt(r, 0));
  const Theorem bounds = book.show(
      "rest_bounds", "", "where what is left is half a step at most:",
      tautology(logic_and({le(0, f("rest")), le(f("rest"), half_h)}),
                {with_sign(root_above, above.conclusion(), r_up, above),
                 with_sign(root_below, below.conclusion(), r_down, linear(le(r, 0), {below})),
                 use("equal or less or greater", {{x, r}, {y, 0}})}));
  const Expr q = psi() / 4;
  const Theorem q_is = linear(eq(half_h, q), {psi_is});
  const Expr gap_angle = q - f("rest");
  const Theorem gap_from = linear(le(0, gap_angle), {part(bounds, 1), q_is});
  const Theorem gap_below = linear(
      lt(gap_angle, pi()), {part(bounds, 0), part(book["rotation.psi_range"], 1), psi_positive});
  const Theorem sine_from_0 = sine_not_negative(gap_from, linear(le(gap_angle, pi()), {gap_below}));
  const Theorem difference =
      equation(sin(gap_angle), sin(q) * f("rest_cosine") - cos(q) * f("rest_sine"),
               angles({sin(gap_angle)}, {q, f("rest")}, false) +
                   Theorems{turned(def_sine), turned(def_cosine)});
  Certificate c;  // cos(q) (t cos(rest) - sin(rest)) = sin(q - rest)
  c.multipliers = {a.cos_positive};
  c.nonzero = {a.cos_positive};
  c.equations = {{1, difference}, {-cos(q), parts[0]}, {-cos(q) * f("rest_cosine"), a.tangent}};
  c.products = {{1, {sine_from_0}, {}}};
  book.show(
      "t_cosine_at_most", "", "For a ball that is not heavier than a block",
      under({alpha_positive, V_positive}, larger(a.t_small, f("rest_cosine"), parts[0], parts[1])));
  book.show("sine_at_most", "", "and so", arithmetic(le(f("rest_sine"), f("t_cosine")), c));
}
}  // namespace derivation
