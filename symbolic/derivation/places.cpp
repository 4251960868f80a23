// When and where the collisions take place: the motion from any start, with the ball and B at rest.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
/// A and C touch, and B is at a distance L.
const Substitution distances{{d_A, 0}, {d_B, L}};
/// Times and places of the collisions, from each to the next.
void until_the_next(Book& book) {
  const Known here;
  const Theorem going = assume(lt(0, closing(j)));
  know(going);
  const Exprs domain = of_wedge({le(0, j), lt(0, e), V_positive, lt(0, L), going.conclusion()});
  const Names names{book, {M_A, w_B, M_C, e, V, L, j}, domain};
  know(rewrite(part(book["motion.names"], 3), going));
  const auto from = [&](const std::string& id) {
    return from_rest(book, book["any_start." + id], distances);
  };
  const Theorem when = from("instant");
  const Theorem time = names.name("time", left(when), "Collision j takes place at the time");
  const auto shown = [&](const char* id, const char* words, const Theorem& t) {
    return book.show(id, words, under({going.conclusion()}, t));
  };
  Theorems named{turned(time)}, places;
  for (const std::string body : {"A", "B", "C"}) {
    const Expr on_line = fun("place_" + body, at_rest() + Exprs{0, 0, L, left(time), j});
    const Theorem place = names.name("x_" + body, L + on_line, "with " + body + " at");
    places.push_back(place);
    named.push_back(solved_for(on_line, place));
  }
  const auto named_in = [&](const char* id) { return rewritten(named, from(id)); };
  const Expr A = at_collision("x_A", j), B = at_collision("x_B", j), C = at_collision("x_C", j);
  know(tautology(lt(0, U(j)), {book["motion.takes_place"], going}));
  const auto is = [](Expr term, const Theorem& t) { return chain(equation(term, left(t)), t); };
  const Theorem met = shown("met", "There the two bodies of the collision are at one place:",
                            is(is_P(j) * (C - A) + is_Q(j) * (B - C), named_in("met")));
  const Theorem ball = shown(
      "ball", "the ball and a block,",
      arithmetic(eq(C, is_P(j) * A + is_Q(j) * B),
                 {.equations = {{turn(j), met}, {(A + B) / 2 - C, book["cycle.turn_squared"]}}}));
  const Theorem later = named_in("apart");
  const Theorem r_e_is = book["any_start.def_r_e"];
  const Theorems factors{at(part(book["cycle.turn"], 1)), book["cycle.turn_squared"],
                         at(part(at(book["multiples.pow"], {{y, sqrt(e)}}), 1)), r_e_is};
  shown("distance", "The blocks are then so far apart,",
        chain(is(B - A, later),
              equation(right(later), L * root_power(j) / (side(j) * U(j)), factors)));
  const Theorem speed = book["any_start.speed"];
  shown("time", "and the collision takes place at the time",
        equation(left(time), L * r_B() * U_last(j) / (V * r_A() * sqrt(e) * U(j)),
                 {time, when, book["motion.speed"], at(speed, start_with(0, L)), r_e_is}));
  const Expr goes_further = lt(0, closing(j + 1)), next_time = at_collision("time", j + 1);
  Theorems lines, next;
  for (const Theorem& moves : parts({named_in("goes_on")})) {
    const std::size_t body = lines.size();
    const Theorem& place = named[body + 1];
    const Theorem moved = rewrite(at(place, {{j, j + 1}}), at(moves, {{tau, next_time}}));
    const Theorem line = at(part(from("linear"), body), {{tau, left(time)}});
    const Expr x_is = left(places[body]), v = velocity(std::string(1, "ABC"[body]), j + 1);
    next.push_back(
        linear(eq(substitute(x_is, {{j, j + 1}}), x_is + v * (next_time - left(time))), {moved}));
    lines.push_back(solved_for(x_is, rewrite(place, line)));
  }
  shown("next", "and until the next collision all move on with their velocities:",
        under({goes_further}, both(next)));
  const Theorem carried = shown(
      "carried", "The centre of mass, if there is no wall, moves on evenly:",
      equation(w_B * (M_A * A + M_C * C) + B, L + w_B * M_A * V * left(time),
               lines + Theorems{solved_for(velocity("B", j), from("momentum")),
                                solved_for(substitute(any_velocity("B", j), start_with(0, L)),
                                           at(book["any_start.momentum"], start_with(0, L)))}));
  const Expr D = B - A, all = mass_of_all();
  const Expr whole = L + w_B * M_A * V * left(time) - is_P(j) * D + is_Q(j) * (w_B * M_A * D);
  shown("place", "so the ball is at",
        divided(C, all, equation(C * all, whole, {solved_for(L, carried), ball})));
}
/// Where they never end, all times are below one that they come arbitrarily close to.
void collapse_in_time(Book& book) {
  const Theorem from_1 = assume(le(1, kappa()));
  know(from_1);
  const Theorem neighbours = cut(from_1, book["collapse.neighbours"]);
  for (const Theorem& positive_power : parts({neighbours})) know(positive_power);
  const Expr y_e = left(cut(from_1, book["collapse.y_e"])),
             unit = L * r_B() / (V * r_A() * sqrt(e));
  const Theorem rise = at(book["chebyshev.rise"], {{x, kappa()}});
  know(linear(lt(0, U(j)), {rise}));
  const Theorem end_is = book.define("t_end", {M_A, w_B, M_C, e, V, L}, unit * y_e,
                                     of_wedge({lt(0, e), le(1, kappa()), V_positive, lt(0, L)}),
                                     "Where the collisions never end, there is a time");
  const Expr rest = unit * right(part(neighbours, 0)) / U(j), per = unit / U(j);
  const Theorem closes = book["motion.never_ends"], in_time = cut(closes, book["places.time"]);
  know(closes);
  book.show(
      "time_left", "before which all collisions take place,",
      equation(left(end_is) - left(in_time), rest, {end_is, in_time, turned(part(neighbours, 0))}));
  book.show("in_time", "and come as close to it as you like:",
            both({positive(rest),
                  linear(le((j + 1) * rest, unit),
                         {times(part(rise, 0), per), times(part(neighbours, 2), (j + 1) * per)})}));
}

// When and where the paper's collisions take place: blocks of mass 1, a ball of mass alpha, e = 1.

Expr sine(Expr times) { return sin(times * half()); }
}  // namespace

void places(Book& book) {
  book.chapter("places", "When and where", of_wedge({le(0, j), lt(0, e), V_positive, lt(0, L)}));
  for (Expr i : {j, j + 1}) know(at(book["wedge.signs"], {{j, i}}));
  until_the_next(book);
  collapse_in_time(book);
}

Theorems quotients_of_sines(const Book& book, const Theorem& kappa_is) {
  const Expr angle = right(kappa_is).arg(0);
  const auto quotient = [&](const char* id) {
    const Theorem product = rewrite(turned(kappa_is), at(book[id], {{y, angle}}));
    return divided(left(product).arg(0), sin(angle), product);
  };
  return {quotient("chebyshev.sine"), quotient("chebyshev.sine_last")};
}
Theorems without_losses(const Book& book, const Theorem& kappa_is) {
  const Theorem root = root_is(1, 1);
  const auto power = [](Expr i) { return fun("pow", {sqrt(Expr(1)), i}); };
  const Theorems powers = parts({at(book["multiples.pow"], {{y, sqrt(Expr(1))}})});
  const Theorem power_is = by_induction(j, eq(power(j), 1), {powers[0]}, {at(powers[1]), root});
  return Theorems{power_is, root} + quotients_of_sines(book, kappa_is);
}

void encounters(Book& book) {
  const Exprs assumptions{alpha_positive, V_positive, lt(0, L), le(0, j), lt(j, N())};
  book.chapter("encounters", "When and where, in the paper's case", assumptions);
  know(in_paper(book["wedge.signs"]));
  // In the paper's case kappa is a cosine and the ratio of the sides is 1.
  const Theorem is_cosine = part(at(book["collapse.elastic"], {{M, 1}}), 0);
  const Theorems rules =
      without_losses(book, restate(eq(in_paper(kappa()), cos(half())), is_cosine)) +
      Theorems{chain(in_paper(book["wedge.r_A"]), turned(in_paper(book["wedge.r_B"])))};
  const Theorem speed =
      book.show("speed", "In the paper's case the approach speeds are those that we know,",
                equation(in_paper(closing(j)), approach(j),
                         rules + Theorems{in_paper(book["motion.speed"]), book["counting.speed"]}));

  const Theorem going = at(part(book["counting.happens"], 0));
  know(book.show("going", "and positive:", linear(lt(0, in_paper(closing(j))), {going, speed})));
  const Exprs params{alpha, V, L, j};
  const Theorem when = defined("when", params, in_paper(at_collision("time", j)), assumptions);
  const Theorem distance = defined("apart", params, in_paper(apart(j)), assumptions);
  book.show("definitions",
            "Collision j takes place at the time when_j, with the blocks apart_j from each other:",
            under(assumptions, both({when, distance})));
  const Theorem positive_sine =
      tautology(lt(0, sin((j + 1) * psi() / 2)), {book["counting.approaches"], going});
  know(restate(lt(0, sine(j + 1)), positive_sine));
  know(positive(rules[2]));
  book.show("when", "For a collision that takes place that is",
            equation(left(when), L / V * (sine(j) / sine(j + 1)),
                     rules + Theorems{when, in_paper(book["places.time"])}));
  book.show("apart", "and",
            equation(left(distance), L * (sin(half()) / sine(j + 1)),
                     rules + Theorems{distance, solved_for(in_paper(at_collision("x_B", j)),
                                                           in_paper(book["places.distance"]))}));
}
}  // namespace derivation
