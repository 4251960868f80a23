// Three bodies from any start: how fast they approach, how often they collide, when and where.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
void closed_form(Book& book, const Theorem& r_e_is) {
  const Theorems pow_is = parts({at(book["multiples.pow"], {{y, sqrt(e)}})});
  const Theorems turns = parts({book["cycle.turn"]});
  const auto of_kappa = [&](const char* id) { return at(book[id], {{x, kappa()}}); };
  const auto claim = [&](Expr i) { return eq(nearing(i), root_power(i) * side(i) * swing(i)); };
  const Theorem last = of_kappa("chebyshev.last");
  const Theorems values = squared_shares(book) + Theorems{book["wedge.kappa"], r_e_is};
  Theorems first = values + Theorems{book["any_start.first"], turns[0], pow_is[0]};
  for (const Theorem& t : {turns[1], pow_is[1], of_kappa("chebyshev.start"), last})
    first.push_back(canonical_form(at(t, {{j, 0}})));
  Theorems next = values + Theorems{book["any_start.recurrence"], book["cycle.turn_squared"]};
  for (const Theorem& t : {turns[1], pow_is[1], last})
    next = next + Theorems{at(t), at(t, {{j, j + 1}})};
  const Theorem speed =
      book.show("speed", "collision j has the approach speed",
                part(by_induction(j, logic_and({claim(j), claim(j + 1)}), first, next), 0));
  know(book["wedge.signs"]);
  book.show("takes_place", "and takes place if and only if a sum is positive:",
            same_sign(iff(lt(0, nearing(j)), lt(0, swing(j))), root_power(j) * side(j), {speed}));
}
/// Where kappa is below 1: how many collisions there are.
void how_many(Book& book) {
  const Known here;
  Exprs domain = of_wedge({lt(0, e), lt(kappa(), 1), V_positive});
  const Theorem cosine = turned(book["wedge.cosine"]);
  know(book["wedge.acute"]);
  const Expr h = right(cosine).arg(0);
  const Expr slope = (kappa() + W / V * r_e()) / sin(h), tilt = atan(slope);
  const Theorem is =
      book.define("phase_e", any_start(), pi() / 2 - tilt, domain,
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
      tautology(iff(lt(0, nearing(j)), lt(0, sin(angle(j + 1)))),
                {book["any_start.takes_place"],
                 same_sign(iff(lt(0, swing(j)), lt(0, sin(angle(j + 1)))), V * length,
                           {restate(eq(swing(j), V * length * sin(angle(j + 1))), sines)})});
  know(both({linear(lt(0, phase), {is}), linear(lt(0, pi() - phase), {is})}));
  count(book, {"N_any", any_start(), domain, nearing, angle, h, (pi() - phase) / h + 1, sign});
}
/// Of a theorem of V and W that of d_A and d_B.
Theorem of_distances(const Theorem& theorem) { return at(theorem, start_with(d_A, d_B)); }
/// The motion as straight lines, which each collision turns.
void line(Book& book) {
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
  const Theorem going = assume(lt(0, nearing(j)));
  know(going);
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
    const Expr moved = place(i) + right(next).arg(0).arg(1) * (tau - T);
    moves.push_back(equation(left(next), moved, there + with("changes") + Theorems{next, meets}));
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
  const Theorem next_going = assume(lt(0, nearing(j + 1))), ordered = assume(le(0, in_order));
  know(next_going);
  const Expr next_T = substitute(T, {{j, j + 1}}), wait = next_T - T;
  const Theorem met = book["any_start.met"];
  Theorems here_and_next = goes_on + Theorems{at(meets, {{j, j + 1}})};
  for (const Theorem& t : with("closing")) here_and_next.push_back(at(t, {{j, j + 1}}));
  here_and_next.push_back(at(part(book["cycle.turn"], 1)));
  const Theorem waited = equation(wait * nearing(j + 1), B - A - left(met), here_and_next);
  const Theorem wait_is =
      divided(wait, nearing(j + 1), linear(eq(wait * nearing(j + 1), B - A), {waited, met}));
  book.show(
      "later", "so that, if A meets the ball first, collisions come one after the other:",
      linear(le(T, next_T),
             {wait_is, times(linear(le(0, B - A), {apart, not_negative(right(apart), {ordered})}),
                             1 / nearing(j + 1))}));
}
/// Where kappa is 1 or more, and B does not run away too fast.
void collapse_from_any_start(Book& book) {
  const Theorem from_1 = assume(le(1, kappa()));
  know(from_1);
  const auto of_collapse = [&](const char* id) { return cut(from_1, book[id]); };
  know(of_collapse("collapse.root"));
  const Expr y_e = left(of_collapse("collapse.y_e")), at_end = V + W * r_e() * y_e;
  const Theorem gap = part(of_collapse("collapse.neighbours"), 0);
  const Theorems rise = parts({at(book["chebyshev.rise"], {{x, kappa()}})});
  know(linear(lt(0, U(j)), rise));
  const Exprs endless = of_wedge({lt(0, e), le(1, kappa())});
  const Theorem speed =
      book.define("end_speed", any_start(), at_end, endless, "Where kappa is 1 or more, with");
  // y_e (swing - r U) = (V - r) y_e^(j+1) + (end_speed - r) U_last
  const Expr r = real("r");
  const Theorems least{assume(lt(0, r)), assume(le(r, V)), assume(le(r, left(speed)))};
  know(both(least));
  const Theorem above =
      arithmetic(le(r * U(j), swing(j)),
                 {.equations = {{r - V, gap}, {U_last(j), speed}},
                  .products = {{1, {least[1], part(of_collapse("collapse.neighbours"), 1)}},
                               {1, {least[2], linear(le(0, U_last(j)), rise)}}},
                  .multipliers = {positive(y_e)}});
  const Theorem rises = book.show("rises", "as long as B does not run away too fast the sum rises,",
                                  linear(le((j + 1) * r, swing(j)), {above, times(rise[0], r)}));
  const Theorem rising = linear(lt(0, swing(j)), {above, positive(r * U(j))});
  know(rising);
  const Theorem closes =
      book.show("never_ends", "so that the collisions never end:",
                tautology(lt(0, nearing(j)), {book["any_start.takes_place"], rising}));
  know(closes);
  const Theorem stays = assume(le(W, 0)), over = assume(le(swing(j), 0));
  const Theorem next = at(book["chebyshev.rise"], {{x, kappa()}, {j, j + 1}});
  const Theorem turns =
      equation(swing(j + 1) * U(j), U(j + 1) * swing(j) + W * r_e(),
               {part(at(book["chebyshev.last"], {{x, kappa()}}), 1),
                solved_for(power(U(j), 2), at(book["chebyshev.neighbours"], {{x, kappa()}}))});
  const Theorem ended =
      scaled(le(swing(j + 1), 0), le(swing(j + 1) * U(j), 0), 1 / U(j),
             {turns, times(over, linear(lt(0, U(j + 1)), {next})), times(stays, r_e())});
  const Theorem sign = book["any_start.takes_place"];
  book.show("once", "If C does not approach B at first, what has ended does not begin again:",
            follows(imp(le(nearing(j), 0), le(nearing(j + 1), 0)),
                    {sign, at(sign, {{j, j + 1}}), discharge(over.conclusion(), ended)}));
  const Exprs ending = endless + Exprs{lt(0, left(speed))};
  const Names names{book, any_start() + Exprs{d_A, d_B}, ending};
  know(linear(lt(0, left(speed)), least));
  const Theorem time =
      names.name("t_any", (d_A + d_B * r_e() * y_e) / left(speed), "There is a time");
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
  const Theorem is_near = linear(le(0, D), {apart, not_negative(right(apart), {ordered})});
  const Theorem weighed =
      arithmetic(eq(D * swing(j), bound),
                 {.equations = {{swing(j), apart}, {1, equation(right(apart) * swing(j), bound)}}});
  shown("come_together", "and the blocks come arbitrarily close to each other,",
        linear(le((j + 1) * r * D, bound), {times(rises, is_near), weighed}));
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

// The motion from rest, in which only A moves at the start.

/// Where kappa is the cosine of an angle h: pi/h collisions, rounded up, less one.
void number(Book& book) {
  const Known here;
  const Exprs domain = of_wedge({lt(0, e), lt(kappa(), 1), V_positive});
  know(book["wedge.acute"]);
  const Theorem cosine = turned(book["wedge.cosine"]);
  const Expr h = right(cosine).arg(0), slope = kappa() / sin(h);
  const Theorem quotient = quotients_of_sines(book, cosine)[0];
  book.show("speed_sine", "Where kappa is below 1 the approach speeds are sines, too,",
            equation(closing(j), V * root_power(j) * side(j) * right(quotient),
                     {book["motion.speed"], quotient}));
  const Theorem length =
      root_is(1 + power(slope, 2), 1 / sin(h), angles({}, {h}) + Theorems{cosine});
  const Theorem tilt =
      same_angle(equation(cos(atan(slope)), cos(pi() / 2 - h),
                          {rewrite(length, at("cos atan", {{x, slope}}))}, {pi() / 2, h}),
                 {positive(atan(slope))});
  const Theorem phase = at(book["any_start.def_phase_e"], {{W, 0}});
  const Theorem many = at(book["any_start.N"], {{W, 0}});
  const Theorem is = book.define("N_e", at_rest(), left(many), domain, "and the number of all is");
  const Theorem turns = rewrite(linear(eq(left(phase), h), {phase, tilt}), chain(is, many));
  book.show("N", "that is,", rewrite(equation(right(turns).arg(0).arg(0), pi() / h), turns));
}
/// One statement for both: that all collisions take place, and that K is 1 or more.
void endless(Book& book) {
  const Expr i = integer("i"), from_1 = le(1, kappa());
  const Theorem every = generalize(i, given(le(0, i), [&](const Theorem& from_0) {
                                     return at(book["motion.never_ends"], {{j, i}}, {from_0});
                                   }));
  const Theorem number = book["motion.N"], is = book["motion.def_N_e"];
  const Expr N = left(number), always = every.conclusion();
  const Theorem turns = positive(right(number).arg(0).arg(0), {book["wedge.acute"]});
  const Known index({linear(le(0, N), {number, turns})});
  const Theorem last = part(at(book["any_start.happens"], {{W, 0}}), 1);
  const Theorem ended = from_rest(book, rewrite(turned(is), last), {}, {N});
  const Theorem another =
      tautology(lt(0, closing(N)), {specialize(assume(always), N), linear(le(0, N))});
  const Theorem ends = refute(always, linear(lt(0, 0), {another, ended}));
  book.show("endless", "The collisions never end if and only if K is 1 or more:",
            tautology(iff(always, le(1, left(book["collapse.def_K"]))),
                      {book["collapse.threshold"], discharge(from_1, every),
                       discharge(lt(kappa(), 1), ends)}));
}
}  // namespace

void from_any_start(Book& book) {
  book.chapter("any_start", "Three bodies from any start", of_wedge({le(0, j), lt(0, e)}));
  sequences(book);
  know(at(book["wedge.signs"], {{j, 0}}));
  const Theorem r_e_is =
      book.define("r_e", masses_and_e(), r_B() / (r_A() * sqrt(e)), of_wedge({lt(0, e)}),
                  "With a number by which the ball's approach to B counts,");
  know(positive(r_e_is));
  closed_form(book, r_e_is);
  how_many(book);
  line(book);
  collapse_from_any_start(book);
}

Theorem from_rest(const Book& book, const Theorem& t, Substitution terms, const Exprs& indices) {
  terms.insert({W, 0});
  Theorem out = at(t, terms);
  for (const Theorem& is : parts({book["motion.names"]}))
    for (Expr i : indices) out = rewrite(turned(at(is, {{j, i}}, {assume(le(0, j))})), out);
  return out;
}

void motion(Book& book) {
  book.chapter("motion", "Two bodies at rest", of_wedge({le(0, j), lt(0, e), V_positive}));
  Theorems names;
  const auto named = [&](const std::string& symbol, Expr of_any) {
    names.push_back(
        defined(symbol, at_rest() + Exprs{j}, substitute(of_any, {{W, 0}}), of_wedge({le(0, j)})));
  };
  for (const std::string body : {"A", "B", "C"}) named("v_" + body, any_velocity(body, j));
  named("closing", nearing(j));
  book.show("names", "With the ball and B at rest at the start all is named anew:", both(names));
  const auto show = [&](const std::string& id, const char* words, const Exprs& indices) {
    book.show(id, words, from_rest(book, book["any_start." + id], {}, indices));
  };
  book.show("start", "At the start",
            canonical_form(from_rest(book, book["any_start.start"], {}, {0})));
  show("next", "Collision j is one of A and C, or of C and B, by turns:", {j, j + 1});
  show("closing", "Before collision j its two bodies approach with the speed", {j});
  show("recurrence", "and each one follows from two before:", {j, j + 1, j + 2});
  for (Expr i : {Expr(0), j}) know(at(book["wedge.signs"], {{j, i}}));
  know(positive(book["wedge.kappa"]));
  const Expr U_j = U(j), closes = closing(j), factor = V * root_power(j) * side(j);
  const Theorem speed =
      book.show("speed", "So collision j has the approach speed",
                equation(closes, factor * U_j, {from_rest(book, book["any_start.speed"])}));
  book.show("takes_place", "and takes place if and only if U_j is positive:",
            same_sign(iff(lt(0, closes), lt(0, U_j)), factor, {speed}));
  number(book);
  const Known from_1({assume(le(1, kappa()))});
  book.show(
      "never_ends", "Where kappa is 1 or more, the collisions never end:",
      tautology(lt(0, closes), {book["motion.takes_place"],
                                linear(lt(0, U_j), {at(book["chebyshev.rise"], {{x, kappa()}})})}));
  endless(book);
}
}  // namespace derivation
