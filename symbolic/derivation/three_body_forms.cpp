// SPDX-License-Identifier: GPL-2.0-or-later
// Forms for evaluation: three bodies of any masses, or two and a wall, with restitution.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
Expr h_e() { return fun("h_e", masses_and_e()); }
Expr sine(Expr times) { return sin(times * h_e()); }

Expr K() { return fun("K", masses_and_e()); }
Expr q_e() { return fun("q_e", masses_and_e()); }

/// Names of quantities of collision j, and the forms that are shown for them.
struct Forms : Names {
  Theorem below;  ///< |- kappa < 1
  Theorems shared = {};

  /// A theorem of the wedge, as kappa is below 1.
  Theorem in_angle(const std::string& id, const Substitution& terms = {}) const {
    return cut(below, at(book["wedge." + id], terms));
  }
  /// |- symbol_j = value, not shown
  Theorem name(const std::string& symbol, Expr value) const {
    return defined(symbol, params, value, domain);
  }
  /// Shows that what is so named has a form.
  Theorem show(const Theorem& is, const std::string& words, Expr form,
               const Theorems& rules) const {
    const Expr named = left(is);
    return book.show(named.name(), words, equation(named, form, Theorems{is} + rules + shared));
  }
  /// What the forms share, a positive number where `is_positive`.
  void share(const std::string& symbol, const std::string& words, Expr value, bool is_positive) {
    shared.push_back(name(symbol, value));
    book.show("def_" + symbol, words, under({lt(0, q_e())}, shared.back()));
    if (is_positive) know(algebra::positive(shared.back()));
  }
};

/// Where collisions never end: the blocks come together, and the ball with them at x_end.
void come_together(Book& book, const Theorem& from_1, const Theorem& x_end) {
  const Theorem all_of_them = all_of(j, [&](Expr i, const Theorem& range) {
    return at(cut(from_1, book["wedge.never_ends"]), {{j, i}}, {range});
  });
  const Known here({all_of_them, book["wedge.signs"]});
  const auto there = [&](const char* id) { return cut(all_of_them, book[id]); };
  const Theorem distance = there("places.distance"), place = there("places.place");
  const Expr D = left(distance),
             left_over = fun("t_end", {M_A, w_B, M_C, e, V, L}) - at_collision("time", j);
  book.show(
      "place_left",
      "The ball's distance from that place follows from the time left and that of the blocks,",
      equation(
          left(x_end) - left(place),
          (w_B * M_A * V * left_over + is_P(j) * D - is_Q(j) * (w_B * M_A * D)) / mass_of_all(),
          {x_end, place}));
  // 1/side = is_P + is_Q r_B/r_A, at most 1 + r_B/r_A; powers of sqrt(e) are 1 at most, U_j j + 1
  // or more.
  const Expr root = sqrt(e), U = chebyshev(j, kappa()), ratio = r_B() / r_A();
  const Theorem above = assume(lt(1, root)), no_gain = assume(le(e, 1));
  const Theorem absurd = linear(lt(0, 0), {above, times(above, root), no_gain});
  const Theorem powers = powers_of(book, tautology(le(root, 1), {refute(lt(1, root), absurd)}));
  const Theorem rise = part(at(book["chebyshev.rise"], {{x, kappa()}}), 0);
  know(linear(lt(0, U), {rise}));
  know(rewrite(turned(distance), positive(right(distance))));
  const Theorem turns = book["motion.turn_squared"];
  const Expr sides = is_P(j) + is_Q(j) * ratio;
  know(rewrite(equation(1 / side(j), sides, {turns}), positive(1 / side(j))));
  const Theorem at_most = arithmetic(
      le(sides, 1 + ratio), {.equations = {{(1 + ratio) / 4, turns}},
                             .products = {{1, {}, {is_Q(j)}}, {1, {positive(ratio)}, {is_P(j)}}}});
  const Expr bound = L * root_power(j) * sides;
  const Theorem is = arithmetic(
      eq(D * U, bound),
      {.equations = {{U, distance}, {1, equation(right(distance) * U, bound, {turns})}}});
  book.show("come_together", "and the blocks come arbitrarily close to each other:",
            both({positive(D), linear(le((j + 1) * D, L * (1 + ratio)),
                                      {times(rise, D), is, times(part(powers, 1), L * sides),
                                       times(at_most, L)})}));
}

/// q_e = 1 - K, above 0 where collisions end; the time of the collapse where they do not.
Theorem definition_of_q_e(Book& book) {
  const Theorem q_is = book.define("q_e", masses_and_e(), 1 - K(), of_wedge({lt(0, e)}),
                                   "Collisions end where this is positive:");
  const Theorem none = assume(le(q_e(), 0));
  const Theorem inside = equation(power(kappa(), 2) - 1, -q_e(), {q_is, book["collapse.square"]});
  const Theorem from_1 =
      tautology(le(1, kappa()), {book["collapse.threshold"], linear(le(1, K()), {q_is, none})});
  const Known here({none, from_1});
  book.show("y_e", "Where they never end,", rewrite(inside, cut(from_1, book["collapse.y_e"])));
  book.show("t_end", "and the time of the collapse is", cut(from_1, book["collapse.def_t_end"]));
  const auto at_end = [&](const char* symbol, const char* words, const Exprs& domain, Expr value) {
    return book.define(symbol, {M_A, w_B, M_C, e, V, L}, value / mass_of_all(), of_wedge(domain),
                       words);
  };
  const Theorem x_end =
      at_end("x_end", "All three come together at the centre of mass, or at the wall,",
             {lt(0, e), V_positive, lt(0, L), none.conclusion()},
             L + w_B * M_A * V * fun("t_end", {M_A, w_B, M_C, e, V, L}));
  const Theorem v_end =
      at_end("v_end", "which moves with the velocity (0 for a wall)", {}, w_B * M_A * V);
  book.show("momentum", "at all times, as momentum is kept:",
            chain(book["motion.momentum"],
                  equation(w_B * M_A * V, left(v_end) * mass_of_all(), {v_end})));
  come_together(book, from_1, x_end);
  return q_is;
}
/// Where q_e is above 0 the angle; |- kappa < 1.
Theorem angle(Book& book, const Theorem& q_is) {
  know(assume(lt(0, q_e())));
  const Theorem below =
      tautology(lt(kappa(), 1), {book["collapse.threshold"], linear(lt(K(), 1), {q_is})});
  know(below);
  know(positive(book["wedge.kappa"]));
  const Theorem inside = equation(1 - power(kappa(), 2), q_e(), {q_is, book["collapse.square"]});
  const Theorem h_is = book.show("h_e", "Where they end the angle is",
                                 rewrite(inside, cut(below, book["wedge.h_e"])));
  know(positive(h_is));
  know(linear(lt(h_e(), pi()), {h_is}));
  book.show("N_e", "and the number of all collisions", cut(below, book["wedge.N"]));
  return below;
}
void velocities(const Forms& forms) {
  Book& book = forms.book;
  const Theorem turn_next = at(part(book["cycle.turn"], 1));
  const Theorem pow_next = at(part(at(book["multiples.pow"], {{y, sqrt(e)}}), 1));
  const Theorem before = forms.name("before", closing(j)),
                after = forms.name("after", closing(j + 1));
  const Expr per = V * root_power(j) / forms("step_sine");
  forms.show(before, "Before collision j its bodies approach with the speed",
             per * forms("now_side") * forms("now_sine"), {forms.in_angle("speed_sine")});
  forms.show(after, "those of the next one with",
             sqrt(e) * per * forms("later_side") * forms("later_sine"),
             {forms.in_angle("speed_sine", {{j, j + 1}}), turn_next, pow_next});

  const Expr v = left(after), u = e * left(before);
  const auto named = [&](const char* id) {
    return rewrite(turned(before), rewrite(turned(after), rewrite(turn_next, book[id])));
  };
  const auto next = [&](const char* symbol, const char* body) {
    return forms.name(symbol, velocity(body, j + 1));
  };
  const Theorem B = next("B_next", "B"), A = next("A_next", "A"), C = next("C_next", "C");
  const Expr of_C = is_P(j) * v - is_Q(j) * u;
  forms.show(B, "so that B then has the velocity",
             w_B * (M_A * (V - v + u) - M_C * of_C) / mass_of_all(), {named("motion.B_velocity")});
  const auto against_B = [&](const Theorem& is, const char* words, Expr difference,
                             const char* id) {
    const Expr value = left(is), of_B = left(B);
    book.show(value.name(), words, linear(eq(value, of_B + difference), {is, B, named(id)}));
  };
  against_B(A, "that of A is", v - u, "motion.A_B");
  against_B(C, "and that of C", of_C, "motion.C_B");
}
void times_and_places(const Forms& forms) {
  Book& book = forms.book;
  const Theorem rest = forms.name("rest_e", pi() - (j + 1) * h_e());
  book.show("def_rest_e",
            "Collision j takes place where this is positive:", under({lt(0, q_e())}, rest));
  know(assume(lt(0, left(rest))));
  const auto in_half_a_turn = [&](Expr i, const Theorem& range) {
    const Theorem less = times(linear(le(0, j - i), {range}), h_e());
    know(times(linear(lt(0, i + 1), {range}), h_e()));
    know(linear(lt((i + 1) * h_e(), pi()), {less, rest}));
    return positive(sine(i + 1));
  };
  const Theorem all_of_them = all_of(j, [&](Expr i, const Theorem& range) {
    const Known here;
    return tautology(lt(0, closing(i)), {at(forms.in_angle("in_the_angle"), {{j, i}}, {range}),
                                         in_half_a_turn(i, range)});
  });
  know(in_half_a_turn(j, linear(le(j, j))));
  know(positive(book["bodies.def_now_sine"]));
  const Theorems sines = quotients_of_sines(book, turned(forms.in_angle("cosine")));
  know(positive(sines[0]));
  const auto of_motion = [&](const char* id) { return cut(all_of_them, book[id]); };
  const Theorem moment = forms.name("moment", at_collision("time", j));
  forms.show(moment, "The time is",
             L / V * (r_B() / r_A()) / sqrt(e) * (sine(j) / forms("now_sine")),
             Theorems{of_motion("places.time")} + sines);
  const Theorem blocks = forms.name("blocks", apart(j)),
                place = forms.name("place", at_collision("x_C", j));
  forms.show(chain(blocks, of_motion("places.distance")), "the distance of A and B",
             L * root_power(j) / forms("now_side") * (forms("step_sine") / forms("now_sine")),
             {sines[0]});
  const Expr D = left(blocks);
  forms.show(
      place, "and the place",
      (L + w_B * M_A * V * left(moment) - is_P(j) * D + is_Q(j) * (w_B * M_A * D)) / mass_of_all(),
      {rewrite(turned(moment), rewrite(turned(blocks), of_motion("places.place")))});
}
}  // namespace

void three_body_forms(Book& book) {
  const Exprs assumptions = of_wedge({le(0, j), lt(0, e), V_positive, lt(0, L)});
  book.chapter("bodies", "Forms for evaluation: three bodies", assumptions);
  know(at(book["wedge.signs"], {{j, 0}}));
  Forms forms{{book, {M_A, w_B, M_C, e, V, L, j}, assumptions},
              angle(book, definition_of_q_e(book))};
  know(book["wedge.signs"]);
  const Expr ratio = r_A() / r_B();
  forms.share("step_sine", "With", sin(h_e()), true);
  forms.share("now_side", "and", is_P(j) + is_Q(j) * ratio, true);
  forms.share("later_side", "and", is_Q(j) + is_P(j) * ratio, false);
  forms.share("now_sine", "and", sine(j + 1), false);
  forms.share("later_sine", "and", sine(j + 2), false);
  velocities(forms);
  times_and_places(forms);
}
}  // namespace derivation
