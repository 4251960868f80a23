// SPDX-License-Identifier: GPL-2.0-or-later
// When and where the collisions take place.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
Expr x_of(const char* body, Expr index) { return at_collision(body, index); }
Expr time_of(Expr index) { return at_collision("time", index); }
Expr U(Expr index) { return chebyshev(index, kappa()); }
Expr U_last(Expr index) { return fun("U_last", {kappa(), index}); }

// What is proved of collision `at`, without quotients: its bodies are at one place; how far the
// blocks are apart; when it takes place; how the centre of mass moves on, times w_B.
Expr met(Expr at) {
  return eq(is_P(at) * (x_of("x_C", at) - x_of("x_A", at)) +
                is_Q(at) * (x_of("x_B", at) - x_of("x_C", at)),
            0);
}
Expr distance(Expr at) { return eq(apart(at) * side(at) * U(at), L * root_power(at)); }
Expr when(Expr at) {
  return eq(time_of(at) * (V * r_A() * sqrt(e)) * U(at), L * r_B() * U_last(at));
}
Expr carried(Expr at) {
  return eq(w_B * (M_A * x_of("x_A", at) + M_C * x_of("x_C", at)) + x_of("x_B", at),
            L + w_B * M_A * V * time_of(at));
}
Expr all_four(Expr at) { return logic_and({met(at), distance(at), when(at), carried(at)}); }

/// Their solutions.
Theorem distance_is(const Theorem& t) {
  return divided(apart(j), L * root_power(j) / (side(j) * U(j)), {side(j), U(j)}, t);
}
Theorem time_is(const Theorem& t) {
  return divided(time_of(j), L * r_B() * U_last(j) / (V * r_A() * sqrt(e) * U(j)),
                 {V, r_A(), sqrt(e), U(j)}, t);
}

/// Places and times: all move on with their velocities until the next collision.
Theorems motion_in_space() {
  return defined_by_recursion(
      {"time", "x_A", "x_B", "x_C"}, {M_A, w_B, M_C, e, V, L}, j,
      of_wedge({le(0, j), all_take_place(j)}), {0, 0, L, 0}, [&](const Exprs& before) {
        const Expr A = before[1], B = before[2], C = before[3];
        const Expr wait = (is_P(j) * (B - C) + is_Q(j) * (C - A)) / closing(j + 1);
        return Exprs{before[0] + wait, A + velocity("A", j + 1) * wait,
                     B + velocity("B", j + 1) * wait, C + velocity("C", j + 1) * wait};
      });
}

/// Collisions 0 to j take place where 0 to j + 1 do.
Theorem but_the_last(const Theorem& all_of_them) {
  return all_of(j, [&](Expr i, const Theorem& range) {
    return tautology(lt(0, closing(i)), {at(specialize(all_of_them, i), {}, {range})});
  });
}
/// |- 0 < closing_index, 0 < U_index
Theorem takes_place(const Book& book, const Theorem& all_of_them, Expr index) {
  const Theorem closes = at(specialize(all_of_them, index));
  return both(
      {closes, tautology(lt(0, U(index)), {at(book["wedge.takes_place"], {{j, index}}), closes})});
}

/// carried(j + 1) from carried(j): momentum is that of V alone.
Theorem moves_on(const Book& book, const Theorems& moved, const Theorem& now) {
  const Theorem v_B = solved_for(velocity("B", j + 1), at(book["motion.momentum"], {{j, j + 1}}));
  const Theorem x_B = solved_for(x_of("x_B", j), now);
  return equation(carried(j + 1), moved + Theorems{v_B, x_B});
}

/// The place of collision j, from how far the blocks are apart.
Theorem ball_is(const Book& book, const Theorem& meets, const Theorem& now) {
  const Expr t = turn(j), x_C = x_of("x_C", j), x_B = x_of("x_B", j), D = apart(j);
  const Theorem turned_round = solved_for(t * x_C, meets);
  const Theorem square = book["motion.turn_squared"];
  const Theorem of_B = chain(equation(x_C, t * (t * x_C), {square}),
                             equation(t * (t * x_C), x_B - is_P(j) * D, {turned_round, square}));
  const Expr all = mass_of_all();
  const Expr whole = L + w_B * M_A * V * time_of(j) - is_P(j) * D + is_Q(j) * (w_B * M_A * D);
  return divided(x_C, whole / all, {all},
                 linear(eq(x_C * all, whole),
                        {now, of_B, equation(w_B * M_A * x_C, w_B * M_A * right(of_B), {of_B})}));
}

/// all_four(j + 1) from all_four(j).
Theorem one_more(const Book& book, const Theorems& motion, const Theorem& now,
                 const Theorem& all_of_them) {
  const auto of_kappa = [&](const char* id) {
    return at(book[std::string("chebyshev.") + id], {{x, kappa()}});
  };
  const Known more({takes_place(book, all_of_them, j), takes_place(book, all_of_them, j + 1)});
  const Theorem turn_next = at(part(book["cycle.turn"], 1));
  const Theorem speed_after = at(book["motion.closing"], {{j, j + 1}});
  Theorems moved{turn_next};
  for (std::size_t i = 4; i < 8; ++i) moved.push_back(at(motion[i]));
  const Theorem meets = equation(met(j + 1), moved + Theorems{rewrite(turn_next, speed_after)});

  // Where the ball is at a block, the wait is the distance of the blocks over the speed.
  const Theorem ball = solved_for(turn(j) * x_of("x_C", j), part(now, 0));
  const Theorem parting =
      linear(eq(velocity("B", j + 1), velocity("A", j + 1) + e * closing(j) - closing(j + 1)),
             {book["motion.parting"], speed_after});
  const Theorem square = book["motion.turn_squared"];
  const Theorem further = equation(apart(j + 1), e * closing(j) * apart(j) / closing(j + 1),
                                   moved + Theorems{parting, ball, square});
  const Theorem later =
      equation(time_of(j + 1), time_of(j) + apart(j) / closing(j + 1), moved + Theorems{ball});

  const Theorem gap = distance_is(part(now, 1));
  const Theorems known_now{turn_next,
                           square,
                           at(part(at(book["multiples.pow"], {{y, sqrt(e)}}), 1)),
                           solved_for(x_of("x_B", j), gap),
                           time_is(part(now, 2)),
                           book["wedge.speed"],
                           at(book["wedge.speed"], {{j, j + 1}})};
  const Theorem B_next = solved_for(x_of("x_B", j + 1), further);
  const Theorem neighbours = solved_for(kernel::power(U(j), 2), of_kappa("neighbours"));
  return both({meets, equation(distance(j + 1), Theorems{B_next} + known_now),
               equation(when(j + 1), Theorems{later, neighbours, of_kappa("last")} + known_now),
               moves_on(book, moved, part(now, 3))});
}
}  // namespace

void when_and_where(Book& book) {
  const Exprs assumptions = of_wedge({le(0, j), lt(0, e), V_positive, lt(0, L)});
  book.chapter("places", "When and where", assumptions);
  know(book["wedge.signs"]);
  const Theorems motion = motion_in_space();

  const auto start = [&](const std::string& id, const Substitution& terms) {
    return part(at(book[id], terms), 0);
  };
  const Theorems starts{motion[0],
                        motion[1],
                        motion[2],
                        motion[3],
                        start("cycle.turn", {}),
                        start("multiples.pow", {{y, sqrt(e)}}),
                        start("chebyshev.start", {{x, kappa()}, {j, 0}}),
                        start("chebyshev.last", {{x, kappa()}, {j, 0}})};
  const auto claim = [](Expr at) { return imp(all_take_place(at), all_four(at)); };
  const Theorem base = tautology(claim(0), {equation(all_four(0), starts)});
  const Theorem together = by_induction(j, claim(j), base, [&](const Theorem& known) {
    return given(all_take_place(j + 1), [&](const Theorem& all_of_them) {
      const Theorem now = tautology(all_four(j), {known, but_the_last(all_of_them)});
      return one_more(book, motion, now, all_of_them);
    });
  });

  const Theorem all_now = assume(all_take_place(j)), one_further = assume(all_take_place(j + 1));
  know(all_of(0, [&](Expr i, const Theorem& range) {
    const Theorem first = at(book["motion.first"], {{j, 0}});
    return linear(lt(0, closing(i)), {rewrite(linear(eq(0, i), {range}), first)});
  }));
  know(but_the_last(one_further));
  know(takes_place(book, one_further, j + 1));
  const Theorem now = tautology(all_four(j), {together, all_now});
  const auto shown = [&](const char* id, const char* words, const Theorem& t,
                         const Theorem& where) {
    Exprs all = assumptions;
    all.push_back(where.conclusion());
    book.show(id, words, under(all, t));
  };
  shown("start", "At first A and C touch, and B is at a distance L:",
        both({motion[0], motion[1], motion[2], motion[3]}), all_now);
  shown("next", "As long as collisions take place, all move on until the next:",
        both({motion[4], motion[5], motion[6], motion[7]}), one_further);
  know(takes_place(book, all_now, j));
  shown("met", "There the two bodies of the collision are at one place:", part(now, 0), all_now);
  shown("distance", "The blocks are then so far apart,", distance_is(part(now, 1)), all_now);
  shown("time", "and the collision takes place at the time", time_is(part(now, 2)), all_now);
  shown("carried", "The centre of mass, if there is no wall, moves on evenly:", part(now, 3),
        all_now);
  shown("place", "so the ball is at", ball_is(book, part(now, 0), part(now, 3)), all_now);
}
}  // namespace derivation
