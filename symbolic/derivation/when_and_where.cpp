// SPDX-License-Identifier: GPL-2.0-or-later
// When and where the collisions take place.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
const Expr i = integer("i");
Expr of_motion(const char* name, Expr index) { return fun(name, {M_A, M_B, M_C, e, V, L, index}); }
Expr v(const char* body, Expr index) {
  return fun(std::string("v_") + body, {M_A, M_B, M_C, e, V, index});
}
Expr pow(Expr index) { return fun("pow", {sqrt(e), index}); }
Expr U(Expr index) { return chebyshev(index, kappa()); }
Expr U_last(Expr index) { return fun("U_last", {kappa(), index}); }
/// l = r from a theorem that says it times `factors`, which are positive.
Theorem divided(Expr l, Expr r, const Exprs& factors, const Theorem& times_factors) {
  Certificate c;
  for (const Expr& f : factors) c.multipliers.push_back(positive(f));
  c.nonzero = c.multipliers;
  c.equations = {{1, times_factors}};
  return arithmetic(eq(l, r), c);
}
/// Collisions 0 to `last` take place.
Expr all_take_place(Expr last) {
  return all(i, imp(logic_and({le(0, i), le(i, last)}), lt(0, closing(i))));
}
/// Collisions 0 to j take place where 0 to j + 1 do.
Theorem but_the_last(const Theorem& all_of_them) {
  const Theorem some = specialize(all_of_them, i);
  return generalize(
      i, given(logic_and({le(0, i), le(i, j)}), [&](const Theorem& range) {
        return tautology(lt(0, closing(i)), {some, part(range, 0), linear(le(i, j + 1), {range})});
      }));
}
}  // namespace

void when_and_where(Book& book) {
  Exprs assumptions = wedge_assumptions();
  assumptions.insert(assumptions.end(), {lt(0, e), V_positive, lt(0, L)});
  book.chapter("places", "When and where", assumptions);
  Theorems given_signs;
  for (const Expr& a : assumptions) given_signs.push_back(assume(a));
  given_signs.push_back(book["wedge.signs"]);
  const Known signs(given_signs);
  const Theorem from = assume(le(0, j)), zero = linear(le(0, 0));
  const Theorems turns = parts({book["cycle.turn"]});

  const Exprs before{real("time_before"), real("x_A_before"), real("x_B_before"),
                     real("x_C_before")};
  const Expr P = (1 + turn(j)) / 2, Q = (1 - turn(j)) / 2;
  const Expr wait = (P * (before[2] - before[3]) + Q * (before[3] - before[1])) / closing(j + 1);
  const Theorems motion = define_recursive(
      {"time", "x_A", "x_B", "x_C"}, {M_A, M_B, M_C, e, V, L}, j, before, {0, 0, L, 0},
      {before[0] + wait, before[1] + v("A", j + 1) * wait, before[2] + v("B", j + 1) * wait,
       before[3] + v("C", j + 1) * wait});
  for (const char* name : {"time", "x_A", "x_B", "x_C"})
    restrict_domain(name, {M_A, M_B, M_C, e, V, L, j},
                    logic_and({lt(0, M_A), lt(0, M_B), lt(0, M_C), le(0, j), all_take_place(j)}));
  const auto time = [](Expr at) { return of_motion("time", at); };
  const auto x_of = [](const char* body, Expr at) { return of_motion(body, at); };
  const auto apart = [&](Expr at) { return x_of("x_B", at) - x_of("x_A", at); };
  const auto met = [&](Expr at) {
    return eq((1 + turn(at)) / 2 * (x_of("x_C", at) - x_of("x_A", at)) +
                  (1 - turn(at)) / 2 * (x_of("x_B", at) - x_of("x_C", at)),
              0);
  };
  const auto distance = [&](Expr at) { return eq(apart(at) * side(at) * U(at), L * pow(at)); };
  const Expr per = V * r_A() * sqrt(e);
  const auto when = [&](Expr at) { return eq(time(at) * per * U(at), L * r_B() * U_last(at)); };
  const auto claim = [&](Expr at) {
    return imp(all_take_place(at), logic_and({met(at), distance(at), when(at)}));
  };
  const auto at_kappa = [&](const char* id, Expr index, const Theorem& from_here) {
    return at(book[std::string("chebyshev.") + id], {{x, kappa()}, {j, index}}, {from_here});
  };
  const Theorems pow_is = parts({instantiate(book["multiples.pow"], {{y, sqrt(e)}})});
  const Theorems starts{motion[0],
                        motion[1],
                        motion[2],
                        motion[3],
                        turns[0],
                        pow_is[0],
                        part(at_kappa("start", 0, zero), 0),
                        part(at_kappa("last", 0, zero), 0)};
  const Theorem base = tautology(claim(0), {equation(met(0), starts), equation(distance(0), starts),
                                            equation(when(0), starts)});
  const Theorem root_e = root_squared(assume(lt(0, e)));
  const auto step = [&](const Theorem& from_here, const Theorem& known,
                        const Theorem& all_of_them) {
    const Theorem now =
        tautology(logic_and({met(j), distance(j), when(j)}), {known, but_the_last(all_of_them)});
    const auto takes_place = [&](Expr index) {
      return use(specialize(all_of_them, index), {},
                 {linear(le(0, index), {from_here}), linear(le(index, j + 1))});
    };
    const auto U_positive = [&](Expr index) {
      return tautology(lt(0, U(index)), {at(book["wedge.takes_place"], {{j, index}}, {from_here}),
                                         takes_place(index)});
    };
    const Theorem closes = takes_place(j + 1);
    const Known more({closes, U_positive(j), U_positive(j + 1)});
    const Expr t = turn(j), x_A = x_of("x_A", j), x_B = x_of("x_B", j);
    const auto next = [&](const Theorem& rule, Expr index) {
      return use(rule, {{j, index}}, {from_here});
    };
    const Theorem turn_next = next(turns[1], j);
    const Theorem ball =
        linear(eq(t * x_of("x_C", j), (t * x_A + t * x_B + x_A - x_B) / 2), {part(now, 0)});
    const Theorem speed_after = at(book["motion.closing"], {{j, j + 1}}, {from_here});
    const Theorem parting =
        linear(eq(v("B", j + 1), v("A", j + 1) + e * closing(j) - closing(j + 1)),
               {book["motion.parting"], speed_after});
    const Theorem speeds = rewrite(turn_next, speed_after);
    Theorems moved{turn_next};
    for (std::size_t which = 4; which < 8; ++which) moved.push_back(next(motion[which], j));
    const Theorem meets = equation(met(j + 1), moved + Theorems{speeds});
    const Theorem further = equation(apart(j + 1), e * closing(j) * apart(j) / closing(j + 1),
                                     moved + Theorems{parting, ball, book["motion.turn_squared"]});
    const Theorem later =
        equation(time(j + 1), time(j) + apart(j) / closing(j + 1), moved + Theorems{ball});
    const Theorem gap =
        divided(x_B, x_A + L * pow(j) / (side(j) * U(j)), {side(j), U(j)}, part(now, 1));
    const Theorem time_is = divided(time(j), L * r_B() * U_last(j) / (per * U(j)),
                                    {V, r_A(), sqrt(e), U(j)}, part(now, 2));
    const Theorem speed_next = at(book["wedge.speed"], {{j, j + 1}}, {from_here});
    const Theorems known_now{
        turn_next, book["motion.turn_squared"], root_e,    next(pow_is[1], j), gap,
        time_is,   book["wedge.speed"],         speed_next};
    return both({meets,
                 equation(distance(j + 1),
                          Theorems{linear(eq(x_of("x_B", j + 1),
                                             x_of("x_A", j + 1) + further.conclusion().arg(1)),
                                          {further})} +
                              known_now),
                 equation(when(j + 1), Theorems{later,
                                                linear(eq(power(U(j), 2), 1 + U(j + 1) * U_last(j)),
                                                       {at_kappa("neighbours", j, from_here)}),
                                                at_kappa("last", j, from_here)} +
                                           known_now)});
  };
  const Theorem together =
      by_induction(j, claim(j), base, [&](const Theorem& from_here, const Theorem& known) {
        return given(all_take_place(j + 1),
                     [&](const Theorem& t) { return step(from_here, known, t); });
      });
  const Expr places = all_take_place(j);
  const Theorem now = tautology(claim(j).arg(1), {together, assume(places)});
  const Theorem U_positive =
      tautology(lt(0, U(j)), {book["wedge.takes_place"],
                              use(specialize(assume(places), j), {}, {from, linear(le(j, j))})});
  const Known more({U_positive});
  assumptions.push_back(places);
  const auto shown = [&](const char* id, const char* words, const Theorem& t) {
    book.show(id, "", words, under(assumptions, t));
  };
  const Theorem at_first = generalize(
      i, given(logic_and({le(0, i), le(i, 0)}), [&](const Theorem& range) {
        const Theorem is_0 = linear(eq(0, i), {range});
        return linear(lt(0, closing(i)), {rewrite(is_0, at(book["motion.first"], {{j, 0}}, {zero})),
                                          assume(V_positive)});
      }));
  know(at_first);
  shown("start", "At first A and C touch, and B is at a distance L:",
        both({motion[0], motion[1], motion[2], motion[3]}));
  know(but_the_last(assume(all_take_place(j + 1))));
  know(use(specialize(assume(all_take_place(j + 1)), j + 1), {},
           {linear(le(0, j + 1), {from}), linear(le(j + 1, j + 1))}));
  Exprs one_more = assumptions;
  one_more.back() = all_take_place(j + 1);
  book.show("next", "", "As long as collisions take place, all move on until the next:",
            under(one_more, both({motion[4], motion[5], motion[6], motion[7]})));
  shown("met", "There the two bodies of the collision are at one place:", part(now, 0));
  shown("distance", "The blocks are then so far apart,",
        divided(apart(j), L * pow(j) / (side(j) * U(j)), {side(j), U(j)}, part(now, 1)));
  shown("time", "and the collision takes place at the time",
        divided(time(j), L * r_B() * U_last(j) / (per * U(j)), {V, r_A(), sqrt(e), U(j)},
                part(now, 2)));
}
}  // namespace derivation
