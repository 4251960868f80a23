// SPDX-License-Identifier: GPL-2.0-or-later
// When and where the collisions take place: the motion from any start, with the ball and B at rest.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
/// A and C touch, and B is at a distance L.
const Substitution from_rest{{W, 0}, {d_A, 0}, {d_B, L}};
/// The velocities and approach speeds of the motion from any start are those that we know.
Theorems as_at_rest(const Book& book) {
  const auto of = [](const Motion& motion) {
    Exprs all;
    for (const char* body : {"A", "B", "C"}) all.push_back(motion.velocity(body, j));
    return all;
  };
  const Exprs any = of(any_start), known = of(at_rest);
  Exprs claims;
  for (std::size_t i = 0; i < 3; ++i) claims.push_back(eq(substitute(any[i], from_rest), known[i]));
  const auto both_of = [&](const std::string& id) {
    return parts({at(book["any_start." + id], from_rest), book["motion." + id]});
  };
  Theorems next = both_of("next");
  for (Theorem& law : next) law = at(law);
  const Theorem velocities = by_induction(j, logic_and(claims), both_of("start"), next);
  Theorems out = parts({velocities});
  out.push_back(
      equation(substitute(any_start.closing(j), from_rest), closing(j), both_of("closing") + out));
  return out;
}
/// The place of collision j, from how far the blocks are apart.
Theorem ball_is(const Book& book, const Theorem& meets, const Theorem& now) {
  const Expr t = turn(j), x_C = at_collision("x_C", j), x_B = at_collision("x_B", j), D = apart(j);
  const Theorem turned_round = solved_for(t * x_C, meets);
  const Theorem square = book["motion.turn_squared"];
  const Theorem of_B = chain(equation(x_C, t * (t * x_C), {square}),
                             equation(t * (t * x_C), x_B - is_P(j) * D, {turned_round, square}));
  const Expr all = mass_of_all();
  const Expr whole =
      L + w_B * M_A * V * at_collision("time", j) - is_P(j) * D + is_Q(j) * (w_B * M_A * D);
  return divided(x_C, whole / all, {all},
                 linear(eq(x_C * all, whole),
                        {now, of_B, equation(w_B * M_A * x_C, w_B * M_A * right(of_B), {of_B})}));
}
/// Times and places of the collisions, from each to the next.
void until_the_next(Book& book) {
  const Known here;
  const Theorems same = as_at_rest(book);
  const Theorem going = assume(lt(0, closing(j)));
  know(going);
  const Exprs params{M_A, w_B, M_C, e, V, L, j};
  const Exprs assumptions =
      of_wedge({le(0, j), lt(0, e), V_positive, lt(0, L), going.conclusion()});
  know(rewrite(turned(same[3]), going));
  const auto from = [&](const char* id) {
    return at(book["any_start." + std::string(id)], from_rest);
  };
  const Theorem when = from("instant");
  const Theorem time =
      book.define("time", params, left(when), assumptions, "Collision j takes place at the time");
  const auto shown = [&](const char* id, const char* words, const Theorem& t) {
    return book.show(id, words, under({going.conclusion()}, t));
  };
  Theorems named{turned(time)}, places;
  for (const std::string body : {"A", "B", "C"}) {
    const Exprs line = any_start.params + Exprs{d_A, d_B, left(time), j};
    const Expr on_line = substitute(fun("any_x_" + body, line), from_rest);
    const Theorem place =
        book.define("x_" + body, params, L + on_line, assumptions, "with " + body + " at");
    places.push_back(place);
    named.push_back(solved_for(on_line, place));
  }
  const auto named_in = [&](const char* id) {
    Theorem out = from(id);
    for (const Theorem& is : named) out = rewrite(is, out);
    return out;
  };
  const Expr A = at_collision("x_A", j), B = at_collision("x_B", j), C = at_collision("x_C", j);
  know(tautology(lt(0, U(j)), {book["wedge.takes_place"], going}));
  const auto is = [](Expr term, const Theorem& t) { return chain(equation(term, left(t)), t); };
  const Theorem met = shown("met", "There the two bodies of the collision are at one place:",
                            is(is_P(j) * (C - A) + is_Q(j) * (B - C), named_in("met")));
  Theorem later = named_in("apart");
  const Theorems goes_on = parts({named_in("goes_on")});
  for (const Theorem& is_there : goes_on) later = rewrite(is_there, later);
  const Theorem r_e_is = book["any_start.def_r_e"];
  const Theorems factors{at(part(book["cycle.turn"], 1)), book["motion.turn_squared"],
                         at(part(at(book["multiples.pow"], {{y, sqrt(e)}}), 1)), r_e_is};
  const Expr D = L * root_power(j) / (side(j) * U(j));
  shown("distance", "The blocks are then so far apart,",
        chain(is(B - A, later), equation(right(later), D, factors)));
  const Theorem speed = book["any_start.speed"];
  shown("time", "and the collision takes place at the time",
        equation(left(time), L * r_B() * U_last(j) / (V * r_A() * sqrt(e) * U(j)),
                 {time, when, at(speed, start_with(V, 0)), at(speed, start_with(0, L)), r_e_is}));
  // Places are lines in time.
  const Expr goes_further = lt(0, closing(j + 1));
  Theorems lines, next;
  for (const Theorem& line : parts({from("linear")})) {
    const std::size_t body = lines.size();
    const Theorem known_line = rewrite(same[body], line);
    const Theorem now = rewrite(named[body + 1], at(known_line, {{tau, left(time)}}));
    const Theorem after = at(known_line, {{tau, left(time)}, {j, j + 1}});
    const Theorem next_one = at(now, {{j, j + 1}});
    const Expr x_is = left(places[body]),
               moved = substitute(right(same[body]), {{j, j + 1}}) *
                       (substitute(left(time), {{j, j + 1}}) - left(time));
    next.push_back(
        linear(eq(substitute(x_is, {{j, j + 1}}), x_is + moved), {after, goes_on[body], next_one}));
    lines.push_back(solved_for(x_is, now));
  }
  know(assume(goes_further));
  shown("next", "and until the next collision all move on with their velocities:",
        under({goes_further}, both(next)));
  const Theorem at_start = at(book["any_start.momentum"], {{V, 0}, {W, L}});
  const Theorem momentum = book["motion.momentum"];
  const Theorem carried = shown(
      "carried", "The centre of mass, if there is no wall, moves on evenly:",
      equation(w_B * (M_A * A + M_C * C) + B, L + w_B * M_A * V * left(time),
               lines + Theorems{solved_for(velocity("B", j), momentum),
                                solved_for(substitute(any_start.velocity("B", j), {{V, 0}, {W, L}}),
                                           at_start)}));
  shown("place", "so the ball is at", ball_is(book, met, carried));
}
/// Where they never end, all times are below one that they come arbitrarily close to.
void collapse_in_time(Book& book) {
  const Theorem from_1 = assume(le(1, kappa()));
  know(from_1);
  const Theorem neighbours = cut(from_1, book["collapse.neighbours"]);
  for (const Theorem& positive_power : parts({neighbours})) know(positive_power);
  const Expr y_e = left(cut(from_1, book["collapse.y_e"])),
             unit = L * r_B() / (V * r_A() * sqrt(e));
  const Expr left_over = right(part(neighbours, 0));
  const Theorem rise = at(book["chebyshev.rise"], {{x, kappa()}});
  know(linear(lt(0, U(j)), {rise}));
  const Theorem end_is = book.define("t_end", {M_A, w_B, M_C, e, V, L}, unit * y_e,
                                     of_wedge({lt(0, e), le(1, kappa()), V_positive, lt(0, L)}),
                                     "Where the collisions never end, there is a time");
  const Expr rest = unit * left_over / U(j), per = unit / U(j);
  const Theorem closes = book["wedge.never_ends"], in_time = cut(closes, book["places.time"]);
  know(closes);
  book.show(
      "time_left", "before which all collisions take place,",
      equation(left(end_is) - left(in_time), rest, {end_is, in_time, turned(part(neighbours, 0))}));
  book.show("in_time", "and come as close to it as you like:",
            both({positive(rest),
                  linear(le((j + 1) * rest, unit),
                         {times(part(rise, 0), per), times(part(neighbours, 2), (j + 1) * per)})}));
}
}  // namespace

void when_and_where(Book& book) {
  book.chapter("places", "When and where", of_wedge({le(0, j), lt(0, e), V_positive, lt(0, L)}));
  for (Expr i : {j, j + 1}) know(at(book["wedge.signs"], {{j, i}}));
  until_the_next(book);
  collapse_in_time(book);
}
}  // namespace derivation
