// SPDX-License-Identifier: GPL-2.0-or-later
// The second part of the chapter any_start: when and where three bodies collide.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
/// Of a theorem of V and W that of d_A and d_B.
Theorem of_distances(const Theorem& theorem) { return at(theorem, start_with(d_A, d_B)); }
/// The motion as straight lines, which each collision turns.
void lines_in_time(Book& book) {
  const Known here;
  const Exprs with_distances = any_start() + Exprs{d_A, d_B};
  const auto by_distances = [](Expr t) { return substitute(t, start_with(d_A, d_B)); };
  const auto twice = [](const Theorem& t) { return parts({t, of_distances(t)}); };
  Theorems lines;
  for (const std::string body : {"A", "B", "C"}) {
    const Expr v = any_velocity(body, j);
    lines.push_back(defined("place_" + body, with_distances + Exprs{tau, j},
                            tau * v - by_distances(v), of_wedge({le(0, j)})));
  }
  book.show("linear",
            "Places are lines in time, and a line begins where it would be a velocity for the "
            "distances d_A and d_B at the start in place of V and W: after j collisions the bodies "
            "are at a time tau, seen from B's first place, at",
            both(lines));
  const Theorem going = know(assume(lt(0, nearing(j))));
  const Theorem when =
      book.name("instant", with_distances + Exprs{j}, by_distances(nearing(j)) / nearing(j),
                of_wedge({le(0, j), lt(0, e), going.conclusion()}),
                "and collision j takes place at the time");
  const Expr T = left(when);
  const Theorem meets = equation(T * nearing(j), by_distances(nearing(j)), {when});
  const auto place = [&](std::size_t i) { return substitute(left(lines[i]), {{tau, T}}); };
  const auto with = [&](const char* id) { return twice(book[std::string("any_start.") + id]); };
  Theorems there;
  for (const Theorem& is : lines) there.push_back(at(is, {{tau, T}}));
  const Expr A = place(0), B = place(1), C = place(2);
  const Expr ahead = by_distances(nearing(j)) - T * nearing(j);
  book.show("met", "where its bodies are at one place,",
            chain(equation(is_P(j) * (C - A) + is_Q(j) * (B - C), ahead, there + with("closing")),
                  equation(ahead, 0, {meets})));
  Theorems moves, goes_on;
  for (std::size_t i = 0; i < 3; ++i) {
    const Theorem next = at(lines[i], {{j, j + 1}});
    moves.push_back(equation(left(next), place(i) + right(next).arg(0).arg(1) * (tau - T),
                             there + with("changes") + Theorems{next, meets}));
    goes_on.push_back(chain(solved_for(place(i), at(moves[i], {{tau, T}})), at(next, {{tau, T}})));
  }
  book.show("goes_on", "from which all move on with their next velocities:", both(moves));

  const Theorem sign = book["any_start.takes_place"], speed_is = book["any_start.speed"];
  know(tautology(lt(0, swing(j)), {sign, going}));
  Theorems facts{when, part(at(book["chebyshev.last"], {{x, kappa()}}), 1),
                 solved_for(power(U(j), 2), at(book["chebyshev.neighbours"], {{x, kappa()}}))};
  for (const Theorem& is : {speed_is, at(speed_is, {{j, j + 1}})}) facts = facts + twice(is);
  for (const Theorem& is : with("A_B")) facts.push_back(solved_for(left(is).arg(0), is));
  know(at(book["wedge.signs"], {{j, j + 1}}));
  const Expr in_order = V * d_B - W * d_A;
  const Theorem apart =
      book.show("apart", "The blocks are then so far apart:",
                equation(B - A, root_power(j + 1) * side(j + 1) * r_e() * in_order / swing(j),
                         goes_on + facts));
  know(assume(lt(0, nearing(j + 1))));
  const Expr next_T = substitute(T, {{j, j + 1}}), wait = next_T - T;
  const Theorem met = book["any_start.met"];
  Theorems here_and_next = goes_on + Theorems{at(meets, {{j, j + 1}})};
  for (const Theorem& t : with("closing")) here_and_next.push_back(at(t, {{j, j + 1}}));
  here_and_next.push_back(at(part(book["cycle.turn"], 1)));
  const Theorem waited = equation(wait * nearing(j + 1), B - A - left(met), here_and_next);
  book.show(
      "later", "so that, if A meets the ball first, collisions come one after the other:",
      linear(
          le(T, next_T),
          {divided(wait, nearing(j + 1), linear(eq(wait * nearing(j + 1), B - A), {waited, met})),
           times(
               linear(le(0, B - A), {apart, not_negative(right(apart), {assume(le(0, in_order))})}),
               1 / nearing(j + 1))}));
}
/// Where kappa is 1 or more, and B does not run away too fast.
void collapse_from_any_start(Book& book) {
  know(assume(le(1, kappa())));
  know(book["collapse.root"]);
  const Expr y_e = left(book["collapse.y_e"]), at_end = V + W * r_e() * y_e;
  const Theorem gap = part(book["collapse.neighbours"], 0);
  const Theorems rise = parts({at(book["chebyshev.rise"], {{x, kappa()}})});
  know(linear(lt(0, U(j)), rise));
  const Exprs endless = of_wedge({lt(0, e), le(1, kappa())});
  const Theorem speed =
      book.define("end_speed", any_start(), at_end, endless, "Where kappa is 1 or more, with");
  // y_e (swing - r U) = (V - r) y_e^(j+1) + (end_speed - r) U_last
  const Expr r = real("r");
  const Theorems least{assume(lt(0, r)), assume(le(r, V)), assume(le(r, left(speed)))};
  know(both(least));
  const Theorem above = arithmetic(
      le(r * U(j), swing(j)), {.equations = {{r - V, gap}, {U_last(j), speed}},
                               .products = {{1, {least[1], part(book["collapse.neighbours"], 1)}},
                                            {1, {least[2], linear(le(0, U_last(j)), rise)}}},
                               .multipliers = {positive(y_e)}});
  const Theorem rises = book.show("rises", "as long as B does not run away too fast the sum rises,",
                                  linear(le((j + 1) * r, swing(j)), {above, times(rise[0], r)}));
  const Theorem rising = know(linear(lt(0, swing(j)), {above, positive(r * U(j))}));
  const Theorem closes =
      know(book.show("never_ends", "so that the collisions never end:",
                     tautology(lt(0, nearing(j)), {book["any_start.takes_place"], rising})));
  const Theorem stays = assume(le(W, 0)), over = assume(le(swing(j), 0));
  const Theorem next = at(book["chebyshev.rise"], {{x, kappa()}, {j, j + 1}});
  const Theorem ended = scaled(
      le(swing(j + 1), 0), le(swing(j + 1) * U(j), 0), 1 / U(j),
      {equation(swing(j + 1) * U(j), U(j + 1) * swing(j) + W * r_e(),
                {part(at(book["chebyshev.last"], {{x, kappa()}}), 1),
                 solved_for(power(U(j), 2), at(book["chebyshev.neighbours"], {{x, kappa()}}))}),
       times(over, linear(lt(0, U(j + 1)), {next})), times(stays, r_e())});
  const Theorem sign = book["any_start.takes_place"];
  book.show("once", "If C does not approach B at first, what has ended does not begin again:",
            follows(imp(le(nearing(j), 0), le(nearing(j + 1), 0)),
                    {sign, at(sign, {{j, j + 1}}), discharge(over.conclusion(), ended)}));
  const Exprs ending = endless + Exprs{lt(0, left(speed))};
  const Names names{book, any_start() + Exprs{d_A, d_B}, ending};
  know(linear(lt(0, left(speed)), least));
  const Theorem time =
      names.name("t_any", (d_A + d_B * r_e() * y_e) / left(speed), "There is a time");
  const Theorem when = cut(closes, book["any_start.instant"]), speed_is = book["any_start.speed"];
  const Expr in_order = V * d_B - W * d_A;
  const Theorem time_left =
      equation(left(time) - left(when), r_e() * in_order * right(gap) / (left(speed) * swing(j)),
               {time, when, speed, speed_is, of_distances(speed_is), solved_for(U_last(j), gap)});
  book.show("time_left", "before which all of them take place,", under(endless, time_left));
  const Theorem apart = cut(closes, book["any_start.apart"]), ordered = assume(le(0, in_order));
  const Expr D = left(apart), bound = root_power(j + 1) * side(j + 1) * r_e() * in_order;
  know(at(book["wedge.signs"], {{j, j + 1}}));
  const Theorem is_near = linear(le(0, D), {apart, not_negative(right(apart), {ordered})});
  const Theorem weighed =
      arithmetic(eq(D * swing(j), bound),
                 {.equations = {{swing(j), apart}, {1, equation(right(apart) * swing(j), bound)}}});
  const Theorem is_close = linear(le((j + 1) * r * D, bound), {times(rises, is_near), weighed});
  book.show("come_together", "and the blocks come arbitrarily close to each other,",
            under(endless, is_close));
  const auto centre = [&](Expr A, Expr C) { return w_B * (M_A * A + M_C * C) / mass_of_all(); };
  const Theorem x_is =
      names.name("x_any", centre((V + W) * left(time) - d_A - d_B, W * left(time) - d_B),
                 "with the ball between them: at the centre of mass, or at the wall,");
  const Theorem v_is =
      book.define("v_any", any_start(), centre(V + W, W), of_wedge({}), "which moves with");
  const Theorem kept = solved_for(any_velocity("B", j), book["any_start.momentum"]);
  const Theorems places = parts({book["any_start.linear"]});
  const Expr x_A = left(places[0]), x_B = left(places[1]), x_C = left(places[2]);
  const Expr moved = left(x_is) + left(v_is) * (tau - left(time));
  book.show("centre", "evenly, all the time:",
            under(ending, equation(w_B * (M_A * x_A + M_C * x_C) + x_B, mass_of_all() * moved,
                                   places + Theorems{x_is, v_is, kept, of_distances(kept)})));
}
}  // namespace

void any_start_line(Book& book) {
  lines_in_time(book);
  collapse_from_any_start(book);
}
}  // namespace derivation
