// SPDX-License-Identifier: GPL-2.0-or-later
// The motion: one sequence of all collisions, P_1, Q_1, P_2, ..., and its matrix Lambda from cycle
// to cycle.
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
const Expr u_1 = real("u_1"), u_2 = real("u_2"), M = real("M");
const Expr from_1 = le(1, n);

/// The velocities that the chapter before gives for a block with u and the ball with w.
struct Collision {
  Expr block_after, ball_after;
  Expr block(Expr u, Expr w) const { return substitute(block_after, {{u_1, u}, {u_2, w}}); }
  Expr ball(Expr u, Expr w) const { return substitute(ball_after, {{u_1, u}, {u_2, w}}); }
};

/// |- 0 <= n implies turn_(2n) = 1, and with it what the two collisions of a cycle do to each body.
struct Sequence {
  Theorems starts;  // of A, B, C
  Theorems first;   // |- A_(2n+1) = ..., B, C under 0 <= n
  Theorems second;  // |- A_(2n+2) = ...
};
Sequence sequence(Book& book, const Collision& collide) {
  const Theorems whose_turn = defined_by_recursion(
      {"turn"}, {}, j, {le(0, j)}, {1}, [](const Exprs& before) { return Exprs{-before[0]}; });
  const Expr P = is_P(j), Q = is_Q(j);
  const auto next = [&](const Exprs& before) {
    const Expr A = before[0], B = before[1], C = before[2];
    return Exprs{P * collide.block(A, C) + Q * A, P * B + Q * collide.block(B, C),
                 P * collide.ball(A, C) + Q * collide.ball(B, C)};
  };
  const Theorems motion = defined_by_recursion({"A", "B", "C"}, {alpha, V}, j,
                                               {alpha_positive, le(0, j)}, {V, 0, 0}, next);
  book.show("turn",
            "Collisions are counted from 0 and alternate between A and B. Whose turn it is, 1 for "
            "A and -1 for B:",
            both(whose_turn));
  book.show("start", "At the start A moves with V; B and C are at rest:",
            both({motion[0], motion[1], motion[2]}));
  book.show("next",
            "Collision j changes the two bodies that take part, by the law of one collision:",
            both({motion[3], motion[4], motion[5]}));

  const Expr even = eq(turn(2 * n), 1);
  const Theorem n_from_0 = assume(le(0, n));
  const auto turn_after = [&](Expr i) { return use(whose_turn[1], {{j, i}}, {n_from_0}); };
  const Theorem turn_0 = by_induction(
      n, even, restate(eq(turn(Expr(2) * Expr(0)), 1), whose_turn[0]),
      [&](const Theorem&, const Theorem& now) {
        return equation(turn(2 * (n + 1)), 1, {turn_after(2 * n + 1), turn_after(2 * n), now});
      });
  const Theorem turn_1 = equation(turn(2 * n + 1), -1, {turn_after(2 * n), turn_0});
  const auto after = [&](Expr i, const Theorem& whose) {
    Theorems steps;
    for (std::size_t body = 3; body < 6; ++body)
      steps.push_back(rewrite(whose, use(motion[body], {{j, i}}, {n_from_0})));
    return steps;
  };
  book.show("turns", "So collision 2n is one with A, and collision 2n + 1 one with B:",
            both({turn_0, turn_1}));
  return {{motion[0], motion[1], motion[2]}, after(2 * n, turn_0), after(2 * n + 1, turn_1)};
}
}  // namespace

void cycle(Book& book) {
  const Theorem law = book["ball.velocities"];
  const Collision collide{left(law).arg(1), right(law).arg(1)};
  book.chapter("cycle", "The motion, cycle by cycle", {alpha_positive, from_1});
  const Sequence s = sequence(book, collide);

  // The paper's names: the n-th cycle is collisions 2n - 2 (P_n) and 2n - 1 (Q_n).
  const Exprs domain{alpha_positive, le(0, n)};
  const auto after_cycle = [&](const char* name, Expr velocity) {
    return defined(name, {alpha, V, n}, velocity, domain);
  };
  const Theorem def_a = after_cycle("a", A(2 * n)), def_b = after_cycle("b", B(2 * n)),
                def_c_prime = after_cycle("c'", C(2 * n));
  const Theorems within =
      defined_by_recursion({"c"}, {alpha, V}, n, domain, {0},
                           [&](const Exprs&) { return Exprs{collide.ball(A(2 * n), C(2 * n))}; });
  const Theorem n_from_1 = assume(from_1);
  book.show("names", "The paper's velocities: A's, B's and the ball's after n cycles,",
            under({alpha_positive, le(0, n)}, both({def_a, def_b, def_c_prime})));
  const auto in_cycle = [&](const Theorem& step) {  // the step of cycle n + 1 as that of cycle n
    return at(step, {{n, n - 1}}, {n_from_1});
  };
  Theorems all_steps;
  for (const Theorem& t : s.first + s.second) all_steps.push_back(in_cycle(t));
  const Theorem def_c = equation(
      c(n), C(2 * n - 1), Theorems{in_cycle(use(within[1], {}, {assume(le(0, n))}))} + all_steps);
  book.show("c_start", "and the ball's within the n-th, 0 before the first:", within[0]);
  book.show("name_c", "so that", def_c);
  Theorems names{turned(def_c)};
  for (const Theorem& t : {def_a, def_b, def_c_prime})
    names = names + Theorems{turned(t), turned(instantiate(t, {{n, n - 1}}))};
  const auto step = [&](Expr l, const Theorem& definition, Expr r) {
    return equation(l, r, Theorems{definition} + all_steps + names);
  };
  const Theorem a_n = step(a(n), def_a, collide.block(a(n - 1), c_prime(n - 1)));
  const Theorem c_n = step(c(n), def_c, collide.ball(a(n - 1), c_prime(n - 1)));
  const Theorem b_n = step(b(n), def_b, collide.block(b(n - 1), c(n)));
  const Theorem c_prime_n = step(c_prime(n), def_c_prime, collide.ball(b(n - 1), c(n)));
  const Theorem zero_n = equation(Expr(2) * Expr(0), 0);
  const auto at_0 = [&](const Theorem& definition, const Theorem& start) {
    return chain(rewrite(zero_n, instantiate(definition, {{n, 0}})), start);
  };
  book.show(
      "start_vector", "Before the first collision:",
      both({at_0(def_a, s.starts[0]), at_0(def_b, s.starts[1]), at_0(def_c_prime, s.starts[2])}));
  book.show("B_waits", "P_n leaves B alone,", equation(B(2 * n - 1), b(n - 1), all_steps + names));
  book.show("P", "After P_n:", both({a_n, c_n}));
  book.show("Q", "After Q_n:", both({b_n, c_prime_n}));
}
}  // namespace derivation
