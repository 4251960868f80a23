// SPDX-License-Identifier: GPL-2.0-or-later
// Three bodies from any start: how fast they approach, how often they collide, when and where.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
Expr approach_of(Expr i) { return any_start.closing(i); }
Expr swing(Expr i) { return V * U(i) + W * r_e() * U_last(i); }
/// Where kappa is below 1: how many collisions there are.
void number(Book& book) {
  const Known here;
  Exprs domain = of_wedge({lt(0, e), lt(kappa(), 1), V_positive});
  know(both(assumed({domain[4], V_positive})));
  const Theorem cosine = turned(book["wedge.cosine"]);
  know(book["wedge.acute"]);
  const Expr h = right(cosine).arg(0);
  know(positive(sin(h)));
  const Expr slope = (kappa() + W / V * r_e()) / sin(h), tilt = atan(slope);
  const Theorem is =
      book.define("phase_e", any_start.params, pi() / 2 - tilt, domain,
                  "Where kappa is below 1 and A approaches the ball, with the angle");
  const Expr phase = left(is), length = sqrt(1 + power(slope, 2));
  const auto angle = [&](Expr i) { return phase + (i - 1) * h; };
  know(positive(length));
  const auto turned_by = [&](Expr value, const char* axiom, Expr over) {
    return rewrite(turned(is),
                   equation(value, over / length, {at(axiom, {{x, slope}})}, {pi() / 2, tilt}));
  };
  const Theorems rules{turned_by(sin(right(is)), "cos atan", 1),
                       turned_by(cos(right(is)), "sin atan", slope), cosine};
  const Theorem sines =
      book.show("sine", "the approach speeds are sines,",
                equation(swing(j), V * length * sin(phase + j * h),
                         rules + quotients_of_sines(book, cosine), {j * h, h, phase}));
  const Theorem sign =
      tautology(iff(lt(0, approach_of(j)), lt(0, sin(angle(j + 1)))),
                {book["any_start.takes_place"],
                 same_sign(iff(lt(0, swing(j)), lt(0, sin(angle(j + 1)))), V * length,
                           {restate(eq(swing(j), V * length * sin(angle(j + 1))), sines)})});
  const Theorems range = parts({at("atan range", {{x, slope}})});
  know(both({linear(lt(0, phase), {range[1], is}), linear(lt(0, pi() - phase), {range[0], is})}));
  count(book,
        {"N_any", any_start.params, domain, approach_of, angle, h, (pi() - phase) / h + 1, sign});
}
/// Of a theorem of V and W that of d_A and d_B.
Theorem of_distances(const Theorem& theorem) { return at(theorem, start_with(d_A, d_B)); }
/// V tau - d_A and W tau - d_B, of which the velocities are places.
Substitution on_the_line(Expr when) { return start_with(V * when - d_A, W * when - d_B); }
/// That a term at the line's speeds is tau times that of V and W, less that of d_A and d_B.
Expr is_linear(Expr term) {
  return eq(substitute(term, on_the_line(tau)),
            tau * term - substitute(term, start_with(d_A, d_B)));
}
/// The places, which are velocities for other speeds at the start; a line for each j.
struct Lines {
  Exprs velocities;
  Theorems named;

  /// A statement about velocities at what V and W are at the time, about places.
  Theorem in_places(Theorem theorem, Expr time) const {
    for (const Theorem& is : named)
      for (Expr i : {j, j + 1}) theorem = rewrite(turned(at(is, {{tau, time}, {j, i}})), theorem);
    return theorem;
  }
};
/// The motion as one straight line, which each collision turns.
void line(Book& book) {
  const Known here;
  Lines lines;
  Exprs& sequences = lines.velocities;
  for (const std::string body : {"A", "B", "C"}) {
    sequences.push_back(any_start.velocity(body, j));
    const Exprs params = any_start.params + Exprs{d_A, d_B, tau, j};
    const Expr value = substitute(sequences.back(), on_the_line(tau));
    lines.named.push_back(defined("any_x_" + body, params, value, of_wedge({le(0, j)})));
  }
  const auto three_times = [&](const Theorem& theorem) {
    return parts({theorem, of_distances(theorem), at(theorem, on_the_line(tau))});
  };
  Theorems next = three_times(book["any_start.next"]);
  for (Theorem& law : next) law = at(law);
  const auto all = [&] {
    Exprs claims;
    for (Expr v : sequences) claims.push_back(is_linear(v));
    return logic_and(claims);
  }();
  const Theorem linear_in_start = by_induction(j, all, three_times(book["any_start.start"]), next);
  book.show(
      "linear",
      "Velocities are linear in those of the start, and so are places: with distances d_A and d_B "
      "at the start, after j collisions the bodies are on these lines at a time tau, seen from "
      "B's first place,",
      lines.in_places(linear_in_start, tau));
  const Theorem speeds = equation(
      is_linear(approach_of(j)), three_times(book["any_start.closing"]) + parts({linear_in_start}));
  const Theorem going = assume(lt(0, approach_of(j)));
  know(going);
  const Theorem when = book.name("instant", any_start.params + Exprs{d_A, d_B, j},
                                 substitute(approach_of(j), start_with(d_A, d_B)) / approach_of(j),
                                 of_wedge({le(0, j), lt(0, e), going.conclusion()}),
                                 "and collision j takes place at the time");
  const Expr T = left(when);
  const Theorem meets =
      equation(substitute(left(speeds), {{tau, T}}), 0, {at(speeds, {{tau, T}}), when});
  const auto there = [&](const Theorem& theorem) { return at(theorem, on_the_line(T)); };
  const auto place = [&](std::size_t i, Expr index) {
    return substitute(substitute(sequences[i], {{j, index}}), on_the_line(T));
  };
  const Expr A = place(0, j), B = place(1, j), C = place(2, j);
  const Theorem speed = there(book["any_start.closing"]);
  const Expr gap = is_P(j) * (C - A) + is_Q(j) * (B - C);
  book.show("met", "where its bodies are at one place,",
            lines.in_places(linear(eq(gap, 0), {speed, meets}), T));
  const auto none = [&](Expr is_one, Expr between) {
    const Expr part = is_one * left(speed);
    return chain(equation(is_one * between, part, {speed, book["motion.turn_squared"]}),
                 equation(part, 0, {meets}));
  };
  Theorems rules{solved_for(turn(j) * A, none(is_P(j), A - C)),
                 solved_for(turn(j) * B, none(is_Q(j), C - B))};
  for (const Theorem& law : parts({there(book["any_start.next"])})) rules.push_back(at(law));
  Theorems same;
  for (std::size_t i = 0; i < 3; ++i) same.push_back(equation(place(i, j + 1), place(i, j), rules));
  book.show("goes_on", "from which the next lines go on:", lines.in_places(both(same), T));

  const Theorem sign = book["any_start.takes_place"], speed_is = book["any_start.speed"];
  know(tautology(lt(0, swing(j)), {sign, going}));
  Theorems facts{when, at(when, {{j, j + 1}}), part(at(book["chebyshev.last"], {{x, kappa()}}), 1),
                 solved_for(power(U(j), 2), at(book["chebyshev.neighbours"], {{x, kappa()}}))};
  for (const Theorem& is : {speed_is, at(speed_is, {{j, j + 1}})})
    facts = facts + Theorems{is, of_distances(is)};
  const Theorem A_B = there(book["any_start.A_B"]);
  const Expr D = place(1, j + 1) - place(0, j + 1), first_in_order = V * d_B - W * d_A;
  know(at(book["wedge.signs"], {{j, j + 1}}));
  book.show("apart", "The blocks are then so far apart:",
            lines.in_places(
                equation(D, root_power(j + 1) * side(j + 1) * r_e() * first_in_order / swing(j),
                         facts + Theorems{solved_for(place(0, j + 1), A_B), meets,
                                          at(speeds, {{j, j + 1}, {tau, T}})}),
                T));
  const Theorem next_one = assume(lt(0, approach_of(j + 1)));
  know(next_one);
  know(tautology(lt(0, swing(j + 1)), {at(sign, {{j, j + 1}}), next_one}));
  const Expr later = r_e() * first_in_order / (swing(j) * swing(j + 1));
  book.show("later", "Collisions follow each other after",
            equation(substitute(T, {{j, j + 1}}) - T, later, facts));
}
/// Where kappa is 1 or more, and B does not run away too fast.
void collapse_from_any_start(Book& book) {
  const Theorem from_1 = assume(le(1, kappa()));
  know(from_1);
  const auto of_collapse = [&](const char* id) { return cut(from_1, book[id]); };
  know(of_collapse("collapse.root"));
  know(of_collapse("collapse.neighbours"));
  const Expr y_e = left(of_collapse("collapse.y_e")), at_end = V + W * r_e() * y_e;
  const Theorem gap = part(of_collapse("collapse.neighbours"), 0);
  const Theorem rise = part(at(book["chebyshev.rise"], {{x, kappa()}}), 0);
  know(linear(lt(0, U(j)), {rise}));
  const Theorems last = parts({at(book["chebyshev.last"], {{x, kappa()}})});
  const Theorem last_from_0 = by_induction(
      j, le(0, U_last(j)),
      linear(le(0, U_last(0)), {part(at(book["chebyshev.last"], {{x, kappa()}, {j, 0}}), 0)}),
      [&](const Theorem&) {
        return linear(le(0, U_last(j + 1)), {last[1], rise});
      });
  const Exprs endless = of_wedge({lt(0, e), le(1, kappa())});
  const Theorem speed =
      book.define("end_speed", any_start.params, at_end, endless, "Where kappa is 1 or more, with");
  // y_e (swing - r U) = (V - r) y_e^(j+1) + (end_speed - r) U_last
  const Expr r = real("r");
  const Theorems least{assume(lt(0, r)), assume(le(r, V)), assume(le(r, left(speed)))};
  know(both(least));
  const Theorem above =
      arithmetic(le(r * U(j), swing(j)),
                 {.equations = {{r - V, gap}, {U_last(j), speed}},
                  .products = {{1, {least[1], part(of_collapse("collapse.neighbours"), 1)}},
                               {1, {least[2], last_from_0}}},
                  .multipliers = {positive(y_e)}});
  const Theorem rises = book.show("rises", "as long as B does not run away too fast the sum rises,",
                                  linear(le((j + 1) * r, swing(j)), {above, times(rise, r)}));
  const Theorem rising = linear(lt(0, swing(j)), {above, positive(r * U(j))});
  know(rising);
  const Theorem closes =
      book.show("never_ends", "so that the collisions never end:",
                tautology(lt(0, approach_of(j)), {book["any_start.takes_place"], rising}));
  know(closes);
  const Exprs ending = endless + Exprs{lt(0, left(speed))};
  const auto name = [&](const char* symbol, Expr value, const char* words) {
    return book.define(symbol, any_start.params + Exprs{d_A, d_B}, value, ending, words);
  };
  know(linear(lt(0, left(speed)), least));
  const Theorem time = name("t_any", (d_A + d_B * r_e() * y_e) / left(speed), "There is a time");
  const auto shown = [&](const char* id, const char* words, const Theorem& theorem) {
    book.show(id, words, under(endless, theorem));
  };
  const Theorem when = cut(closes, book["any_start.instant"]), speed_is = book["any_start.speed"];
  const Expr in_order = V * d_B - W * d_A;
  shown(
      "time_left", "before which all of them take place,",
      equation(left(time) - left(when), r_e() * in_order * right(gap) / (left(speed) * swing(j)),
               {time, when, speed, speed_is, of_distances(speed_is), solved_for(U_last(j), gap)}));
  const Theorem apart = cut(closes, book["any_start.apart"]), ordered = assume(le(0, in_order));
  const Expr D = left(apart), bound = root_power(j + 1) * side(j + 1) * r_e() * in_order;
  know(at(book["wedge.signs"], {{j, j + 1}}));
  const Theorem is_near =
      linear(le(0, D), {apart, times(ordered, root_power(j + 1) * side(j + 1) * r_e() / swing(j))});
  const Theorem weighed =
      arithmetic(eq(D * swing(j), bound),
                 {.equations = {{swing(j), apart}, {1, equation(right(apart) * swing(j), bound)}}});
  shown("come_together", "and the blocks come arbitrarily close to each other,",
        linear(le((j + 1) * r * D, bound), {times(rises, is_near), weighed}));
  const auto centre = [&](Expr A, Expr C) { return w_B * (M_A * A + M_C * C) / mass_of_all(); };
  name("x_any", centre((V + W) * left(time) - d_A - d_B, W * left(time) - d_B),
       "with the ball between them: at the centre of mass, or at the wall,");
  book.define("v_any", any_start.params, centre(V + W, W), of_wedge({}), "which moves with");
}
}  // namespace

void from_any_start(Book& book) {
  book.chapter("any_start", "Three bodies from any start", of_wedge({le(0, j), lt(0, e)}));
  sequences(book, any_start,
            "From another start A approaches the ball with V and the ball B with W, seen from B:");
  know(at(book["wedge.signs"], {{j, 0}}));
  const Theorem r_e_is =
      book.define("r_e", masses_and_e(), r_B() / (r_A() * sqrt(e)), of_wedge({lt(0, e)}),
                  "With a number by which the ball's approach to B counts,");
  know(positive(r_e_is));
  const Theorem speed = book.show(
      "speed", "collision j has the approach speed",
      approach_speeds(book, any_start, [](Expr i) { return root_power(i) * side(i) * swing(i); },
                      {book["wedge.kappa"], r_e_is}));
  know(book["wedge.signs"]);
  book.show(
      "takes_place", "and takes place if and only if a sum is positive:",
      same_sign(iff(lt(0, approach_of(j)), lt(0, swing(j))), root_power(j) * side(j), {speed}));
  number(book);
  line(book);
  collapse_from_any_start(book);
}
}  // namespace derivation
