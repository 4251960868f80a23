// SPDX-License-Identifier: GPL-2.0-or-later
// Evaluated forms of the terminal velocities with restitution, of two blocks and a ball.
#include "derivation/evaluators.hpp"
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
Expr of_e(const std::string& name) { return fun(name, {alpha, e}); }

/// t = tan(h_e/2), without cancellation but in `share_e`, which is 1 or less. |- h_e = step_e.
Theorem angle(Book& book, Names& f) {
  const Theorem rise = f.positive("rise_e", 4 * e * (alpha * (2 + alpha)), "With");
  f.name("root_e", sqrt(e));
  const Theorem loss = f.name("loss_e", power(1 - e, 2) / of_e("rise_e"));
  const Theorem share = f.name("share_e", 1 - of_e("loss_e"));
  const Theorem ends = assume(lt(0, of_e("share_e")));
  know(ends);
  f.domain.push_back(ends.conclusion());
  const Theorem whole = f.positive("whole_e", 2 * sqrt(e) * (1 + alpha) + (1 + e));
  const Theorem gap_e = f.positive("gap_e", of_e("rise_e") * of_e("share_e"));
  const Expr gap = of_e("gap_e"), W = of_e("whole_e");
  const Theorem z = f.positive("z_e", gap / power(W, 2));
  const Theorem t = f.positive("t_e", sqrt(gap) / W);
  const Expr T = left(t);
  const Theorem square =
      book.show("t_squared", "", "t^2 is", equation(power(T, 2), of_e("z_e"), {t, z}));
  // gap = (2 sqrt(e)(1 + alpha))^2 - (1 + e)^2
  const Theorem gap_is = equation(gap, power(2 * sqrt(e) * (1 + alpha), 2) - power(1 + e, 2),
                                  {gap_e, rise, share, loss});
  const Theorem q = for_blocks(book["bodies.def_q_e"]), K = for_blocks(book["collapse.def_K"]);
  const Expr q_e = left(q), D = 4 * e * power(1 + alpha, 2);
  const Theorem q_positive = positive(equation(q_e, gap / D, {q, K, gap_e, rise, share, loss}));
  know(q_positive);
  const Expr kappa_e = substitute(kappa(), blocks_of_paper);
  know(tautology(lt(kappa_e, 1), {for_blocks(book["collapse.threshold"]),
                                  linear(lt(left(K), 1), {q, q_positive})}));
  // (1 - t^2)/(1 + t^2) = kappa
  const Theorem step = f.positive("step_e", 2 * atan(T));
  const Expr half = atan(T);
  const Theorem parts_of_kappa =
      equation(kappa_e, (1 + e) / (2 * sqrt(e) * (1 + alpha)),
               {for_blocks(book["wedge.kappa"]), for_blocks(book["wedge.r_A"]),
                for_blocks(book["wedge.r_B"])});
  const Theorems of_half{at("cos atan", {{x, T}}), at("sin atan", {{x, T}}), square};
  const Theorem cosine = equation(cos(2 * half), kappa_e,
                                  of_half + Theorems{z, gap_is, whole, parts_of_kappa}, {half});
  const Theorem sine = f.positive("sine_e", 2 * T / (1 + of_e("z_e")));
  book.show("sine", "", "the sine of step_e:",
            rewrite(turned(step),
                    equation(sin(2 * half), of_e("sine_e"), of_half + Theorems{sine}, {half})));
  const Theorem same =
      same_angle(chain(cosine, turned(for_blocks(book["wedge.cosine"]))),
                 {positive(half), at("atan range", {{x, T}}), for_blocks(book["wedge.acute"])});
  return book.show("h_e", "", "the angle is",
                   linear(eq(of_e("step_e"), right(same)), {same, step}));
}

/// Both speeds with which bodies part after the last collision, then the velocities.
void velocities(Book& book, Names& f, const Theorem& step) {
  const Expr N = substitute(fun("N_e", {M_A, w_B, M_C, e, V}), blocks_of_paper), h = of_e("step_e");
  const Theorem count = book.show("N_e", "", "the number of collisions",
                                  rewrite(turned(step), for_blocks(book["bodies.N_e"])));
  const Theorem some = assume(lt(0, N));
  know(some);
  know(linear(le(1, N), {next_integer(some)}));
  f.domain = {alpha_positive, lt(0, e), V_positive, lt(0, of_e("share_e")), some.conclusion()};
  f.params = {alpha, e, V};
  const Theorem span = f.name("span_e", h * N, "With");
  const Theorem left_is = f.name("left_e", pi() - f("span_e"));
  const Theorem next = f.name("next_e", h - f("left_e"));
  const Theorem sine_is = book["evaluators_restitution.sine"];
  const Theorem power_is = f.name("power_e", root_power(N));
  const Expr Power = f("power_e"), S = of_e("sine_e");
  const Theorem open_ratio = f.name("open_ratio_e", sin(f("next_e")) / S);
  const Theorem last_ratio = f.name("last_ratio_e", sin(f("left_e")) / S);
  const Theorem kept = f.name("kept_e", Power * f("open_ratio_e"));
  const Theorem parted = f.name("parted_e", sqrt(e) * Power * f("last_ratio_e"));
  const Expr v = f("kept_e"), u = f("parted_e");
  const Theorem ball_is = f.name("ball_e", alpha / (2 + alpha));
  const Theorem odd = f.name("odd_e", 1 - turn(N)), even = f.name("even_e", 1 + turn(N));
  const Theorem second = f.name("second_e", f("odd_e") / 2 * v + f("even_e") / 2 * u);

  const Theorem r_A_is = for_blocks(book["wedge.r_A"]), r_B_is = for_blocks(book["wedge.r_B"]);
  const Theorem sides = linear(eq(left(r_B_is), left(r_A_is)), {r_A_is, r_B_is});
  know(positive(r_A_is));
  const auto at_e = [](Expr t) { return substitute(t, blocks_of_paper); };
  const auto closing_is = [&](Expr i) {
    return canonical_form(
        rewrite(sides, rewrite(turned(step), for_blocks(book["wedge.speed_sine"], {{j, i}}))));
  };
  const Exprs bases{pi() / 2, h * N, h};
  const Theorem to_turn = rewrite(span, left_is), to_next = rewrite(to_turn, next);
  const Theorem of_before = closing_is(N - 1), of_after = closing_is(N);
  const Theorem power_next = canonical_form(
      at(part(at(book["multiples.pow"], {{y, sqrt(e)}}), 1), {{j, N - 1}}, {linear(le(0, N - 1))}));
  const Expr before = left(of_before), after = left(of_after);
  const Theorem last =
      book.show("last", "", "After the last collision its bodies part with the speed",
                equation(e * before, V * u,
                         {rewrite(sine_is, of_before),
                          rewrite(to_turn, rewrite(last_ratio, parted)), power_is, power_next},
                         bases));
  const Theorem open = book.show(
      "open", "", "and the other two approach with",
      equation(after, -V * v,
               {rewrite(sine_is, of_after), rewrite(to_next, rewrite(open_ratio, kept)), power_is},
               bases));
  const auto motion = [&](const char* id) {
    return canonical_form(for_blocks(book[id], {{j, N - 1}}));
  };
  const Expr both_speeds = v + u, s = f("second_e"), per = 1 / (2 + alpha), ball = f("ball_e");
  const auto show = [&](const char* symbol, const char* body, Expr form, const Theorems& more) {
    const Theorem is = f.name(symbol, at_e(velocity(body, N)), "and so");
    return book.show(
        symbol, "", "is",
        under(f.domain, equation(f(symbol), V * form,
                                 more + Theorems{is, last, open, second, odd, even, ball_is})));
  };
  const Theorem of_B = motion("motion.B_velocity");
  show("b_end", "B", (1 + both_speeds) * per + ball * s, {of_B});
  const auto against_B = [&](const char* id, const char* body) {
    const Expr own = at_e(velocity(body, N)), B = at_e(velocity("B", N));
    const Theorem difference = motion(id);
    return linear(eq(own, B + right(difference)), {difference});
  };
  show("a_end", "A", (1 - both_speeds) * per + ball * (s - both_speeds),
       {against_B("motion.A_B", "A"), of_B});
  show("c_end", "C", (1 + both_speeds - 2 * s) * per, {against_B("motion.C_B", "C"), of_B});
  f.name("rho_end", power(f("b_end") / V, 2), "B has of the energy the fraction");
}
/// Where two are all: e (1 + alpha)^2 >= (1 + e)^2.
void two_collisions(Book& book, Names& f) {
  const Theorem K = for_blocks(book["collapse.def_K"]);
  const auto compare = [&](const char* symbol, int factor, const char* words) {
    const Expr below = 4 * e * power(1 + alpha, 2);
    const Theorem is = f.name(symbol, factor * e * power(1 + alpha, 2) - power(1 + e, 2));
    book.show(symbol, "", words,
              equation(left(K), rational(factor, 4) - of_e(symbol) / below, {K, is}));
  };
  compare("ends", 4, "the square of kappa is below 1 where this is positive:");
  compare("two", 1, "and below 1/4, the square of the cosine of pi/3,");
  compare("tie", 2, "or 1/2, that of pi/4,");
  const Theorems facts = first_collisions(book, 2);
  f.params = {alpha, e, V};
  f.domain.push_back(V_positive);
  const auto show = [&](const char* symbol, const char* body, Expr form) {
    const Theorem is =
        f.name(symbol, substitute(velocity(body, 2), blocks_of_paper), "After two collisions");
    book.show(symbol, "", "is", equation(left(is), V * form, facts + Theorems{is}));
  };
  show("a_two", "A", (1 - e * alpha) / (1 + alpha));
  show("b_two", "B", power(1 + e, 2) * alpha / power(1 + alpha, 2));
  show("c_two", "C", (alpha - e) * (1 + e) / power(1 + alpha, 2));
  f.name("rho_two", power(f("b_two") / V, 2), "B has of the energy the fraction");
}
}  // namespace

void restitution_forms(Book& book) {
  book.chapter("evaluators_restitution",
               "Forms for evaluation: terminal velocities that lose energy",
               {alpha_positive, lt(0, e), V_positive, lt(0, L)});
  const Names names{book, {alpha, e}, {alpha_positive, lt(0, e)}};
  Names two = names, many = names;
  two_collisions(book, two);
  velocities(book, many, angle(book, many));
}
}  // namespace derivation
