// The motion: one sequence of all collisions, P_1, Q_1, P_2, ...; what each one keeps, and the
// matrix Lambda of a cycle: V_n = Lambda V_(n-1).
#include "derivation/symbols.hpp"

namespace derivation {
namespace {
/// The velocities that the chapter before gives for a block with u and the ball with w.
struct Collision {
  Expr block_after, ball_after;
  Expr block(Expr u, Expr w) const { return substitute(block_after, {{u_1, u}, {u_2, w}}); }
  Expr ball(Expr u, Expr w) const { return substitute(ball_after, {{u_1, u}, {u_2, w}}); }
};

/// What the two collisions of cycle n do to each body.
Theorems sequence(Book& book, const Collision& collide) {
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
  book.show("turn_squared", "As a turn is 1 or -1,",
            by_induction(j, eq(power(turn(j), 2), 1), {whose_turn[0]},
                         {at(whose_turn[1], {}, {assume(le(0, j))})}));
  book.show("start", "At the start A moves with V; B and C are at rest:",
            both({motion[0], motion[1], motion[2]}));
  book.show("next",
            "Collision j changes the two bodies that take part, by the law of one collision:",
            both({motion[3], motion[4], motion[5]}));

  const Theorem n_from_0 = assume(le(0, n));
  const auto turn_after = [&](Expr i) { return at(whose_turn[1], {{j, i}}, {n_from_0}); };
  const Theorem turn_0 = by_induction(n, eq(turn(2 * n), 1), {whose_turn[0]},
                                      {turn_after(2 * n + 1), turn_after(2 * n)});
  const Theorem turn_1 = equation(turn(2 * n + 1), -1, {turn_after(2 * n), turn_0});
  book.show("turns", "So collision 2n is one with A, and collision 2n + 1 one with B:",
            both({turn_0, turn_1}));
  Theorems steps;
  for (const auto& [i, whose] : {std::pair{2 * n, turn_0}, std::pair{2 * n + 1, turn_1}})
    for (std::size_t body = 3; body < 6; ++body)
      steps.push_back(at(rewrite(whose, at(motion[body], {{j, i}}, {n_from_0})), {{n, n - 1}}));
  return steps;
}

void conservation(Book& book, const Theorems& steps) {
  const Expr s = sqrt(alpha);
  const auto proved = [&](Expr goal) { return equation(goal, steps); };
  const auto energy = [&](Expr block, Expr ball) { return power(block, 2) + power(s * ball, 2); };
  book.show("momentum_P", "eq:conservation eq:ac", "P_n keeps momentum (over M)",
            proved(eq(a(n - 1) + alpha * c_prime(n - 1), a(n) + alpha * c(n))));
  const Theorem energy_P =
      book.show("energy_P", "eq:Euc-Pn", "and energy (over M/2);",
                proved(eq(energy(a(n - 1), c_prime(n - 1)), energy(a(n), c(n)))));
  book.show("momentum_Q", "eq:bcp", "Q_n keeps momentum",
            proved(eq(b(n - 1) + alpha * c(n), b(n) + alpha * c_prime(n))));
  const Theorem energy_Q = book.show("energy_Q", "eq:Euc-Qn", "and energy,",
                                     proved(eq(energy(b(n - 1), c(n)), energy(b(n), c_prime(n)))));
  book.show("energy", "eq:energy-conservation-PnQn", "and so does the whole cycle:",
            linear(eq(power(a(n - 1), 2) + power(b(n - 1), 2) + power(s * c_prime(n - 1), 2),
                      power(a(n), 2) + power(b(n), 2) + power(s * c_prime(n), 2)),
                   {energy_P, energy_Q}));
  book.show("relative_P", "eq:Euc-Pn-linear", "The relative velocity turns round at P_n",
            proved(eq(a(n - 1) - c_prime(n - 1), -a(n) + c(n))));
  book.show("relative_Q", "eq:Euc-Qn-linear",
            "and at Q_n:", proved(eq(b(n - 1) - c(n), -b(n) + c_prime(n))));
}

/// No other motion obeys the law: velocities v that a collision leads to are the next ones.
void uniqueness(Book& book) {
  const auto only = [&](Expr u, Expr w, const Theorem& next) {
    const Theorem law = instantiate(book["ball.velocities"], {{u_1, u}, {u_2, w}});
    const auto same = [&](std::size_t i) { return chain(part(law, i), turned(part(next, i))); };
    return both({same(0), same(1)});
  };
  book.show("only_P", "The law allows no other velocities after P_n",
            only(a(n - 1), c_prime(n - 1), book["cycle.P"]));
  book.show("only_Q", "or after Q_n:", only(b(n - 1), c(n), book["cycle.Q"]));
}
}  // namespace

void cycle(Book& book) {
  const Theorem law = book["ball.velocities"];
  const Collision collide{left(law).arg(1), right(law).arg(1)};
  book.chapter("cycle", "The motion, cycle by cycle", {alpha_positive, n_from_1});
  const Theorems all_steps = sequence(book, collide);

  // The paper's names: the n-th cycle is collisions 2n - 2 (P_n) and 2n - 1 (Q_n).
  const Exprs domain{alpha_positive, le(0, n)};
  const auto after_cycle = [&](const char* name, Expr velocity) {
    return defined(name, {alpha, V, n}, velocity, domain);
  };
  const Theorems definitions{after_cycle("a", A(2 * n)), after_cycle("b", B(2 * n)),
                             after_cycle("c'", C(2 * n))};
  const Theorems within =
      defined_by_recursion({"c"}, {alpha, V}, n, domain, {0},
                           [&](const Exprs&) { return Exprs{collide.ball(A(2 * n), C(2 * n))}; });
  book.show("names", "The paper's velocities: A's, B's and the ball's after n cycles,",
            under(domain, both(definitions)));
  const Theorem def_c =
      equation(c(n), C(2 * n - 1),
               Theorems{at(at(within[1], {}, {assume(le(0, n))}), {{n, n - 1}})} + all_steps);
  book.show("c_start", "and the ball's within the n-th, 0 before the first:", within[0]);
  book.show("name_c", "so that", def_c);
  Theorems names{turned(def_c)};
  for (const Theorem& t : definitions)
    names = names + Theorems{turned(t), turned(at(t, {{n, n - 1}}))};
  Theorems starts{book["cycle.start"]};
  for (const Theorem& t : definitions) starts.push_back(at(t, {{n, 0}}));
  book.show("start_vector", "Before the first collision:",
            equation(logic_and({eq(a(0), V), eq(b(0), 0), eq(c_prime(0), 0)}), starts));
  book.show("B_waits", "P_n leaves B alone,", equation(B(2 * n - 1), b(n - 1), all_steps + names));
  const Theorems rules = definitions + Theorems{def_c} + all_steps + names;
  const Expr A_before = a(n - 1), B_before = b(n - 1), C_before = c_prime(n - 1), C_within = c(n);
  book.show("P", "After P_n:",
            equation(logic_and({eq(a(n), collide.block(A_before, C_before)),
                                eq(C_within, collide.ball(A_before, C_before))}),
                     rules));
  book.show("Q", "After Q_n:",
            equation(logic_and({eq(b(n), collide.block(B_before, C_within)),
                                eq(c_prime(n), collide.ball(B_before, C_within))}),
                     rules));
}

void cycle_matrix(Book& book) {
  const Expr s = sqrt(alpha);
  const Theorems steps{book["cycle.P"], book["cycle.Q"]};
  conservation(book, parts(steps));
  uniqueness(book);

  const Theorem gamma = book["ball.Gamma"];
  const Theorems moved = steps + Theorems{gamma};
  const auto entry_of_gamma = [](int row, int col) { return entry(Gamma(), row, col); };
  book.show("at_P", "eq:abc-n", "In terms of Gamma,",
            equation(column({a(n), s * c(n)}),
                     times(Gamma(), column({a(n - 1), s * c_prime(n - 1)})), moved));
  book.show("at_Q", "eq:abcp-n", "and",
            equation(column({b(n), s * c_prime(n)}), times(Gamma(), column({b(n - 1), s * c(n)})),
                     moved));
  const Theorem of_P =
      book.name("Gamma_A", {alpha},
                matrix(3, {entry_of_gamma(0, 0), 0, entry_of_gamma(0, 1), 0, 1, 0,
                           entry_of_gamma(1, 0), 0, entry_of_gamma(1, 1)}),
                {alpha_positive}, "For all three velocities the collision at P_n leaves B alone,");
  const Theorem of_Q = book.name("Gamma_B", {alpha},
                                 matrix(3, {1, 0, 0, 0, entry_of_gamma(0, 0), entry_of_gamma(0, 1),
                                            0, entry_of_gamma(1, 0), entry_of_gamma(1, 1)}),
                                 {alpha_positive}, "and that at Q_n leaves A alone:");
  Expr in_alpha = times(right(of_Q), right(of_P));
  for (int row = 0; row < 2; ++row)
    for (int col = 0; col < 2; ++col)
      in_alpha = replace(in_alpha, entry_of_gamma(row, col), entry(right(gamma), row, col));
  const Theorem of_cycle = book.name("Lambda", {alpha}, simplified(in_alpha), {alpha_positive},
                                     "Multiplied out, a cycle is");
  const Theorems all_rules{of_cycle, of_P, of_Q, gamma};
  book.show("Lambda_product", "eq:Lam-G-G Lam-GAM", "the product of both,",
            equation(Lambda(), times(Gamma_B(), Gamma_A()), all_rules));
  const Expr d = 1 + alpha, less = 1 - alpha, d2 = power(1 + alpha, 2);
  book.show(
      "Lambda_paper", "eq:Lambda", "as the paper writes it:",
      equation(Lambda(),
               matrix(3, {less / d, 0, 2 * s / d, 4 * alpha / d2, less / d, -2 * less * s / d2,
                          -2 * less * s / d2, 2 * s / d, power(less, 2) / d2}),
               {of_cycle}));
  const Expr ct = cos(theta()), st = sin(theta());
  book.show("Lambda_theta", "eq:Lambda-app", "In terms of theta,",
            equation(Lambda(),
                     matrix(3, {ct, 0, st, power(st, 2), ct, -st * ct, -st * ct, st, power(ct, 2)}),
                     all_rules + Theorems{book["ball.cos_theta"], book["ball.sin_theta"]}));
  const Theorem vector =
      book.name("V_", {alpha, V, n}, column({a(n), b(n), s * c_prime(n)}),
                {alpha_positive, le(0, n)}, "The velocities as a vector:", "def:Vn", "vector");
  const Theorems vectors{vector, at(vector, {{n, n - 1}})};
  const Theorem recurrence = book.show(
      "recurrence", "eq:V-n eq:V-n-app", "A cycle takes it to the next:",
      equation(V_vector(n), times(Lambda(), V_vector(n - 1)), vectors + steps + all_rules));
  book.show("Lambda_orthogonal", "Lambda is orthogonal,",
            equation(times(Lambda(), transpose(Lambda())), identity(3), all_rules));
  for (const auto& [name, words, matrix_term, value] :
       {std::tuple{"Gamma_A_determinant", "the determinant of A's collision:", Gamma_A(), -1},
        std::tuple{"Gamma_B_determinant", "the determinant of B's collision:", Gamma_B(), -1},
        std::tuple{"Lambda_determinant", "the determinant of the whole cycle:", Lambda(), 1}})
    book.show(name, words, equation(det(matrix_term), value, all_rules));
  const auto square = [](Expr i) { return times(transpose(V_vector(i)), V_vector(i)); };
  const Theorem kept = book.show("V_squared", "eq:V2", "so the length of V_n is kept,",
                                 equation(square(n), square(n - 1), {recurrence, of_cycle}));
  book.show("V_length", "eq:V2", "and is always that of V_0:",
            by_induction(n, eq(square(n), square(0)), equation(square(0), square(0)),
                         [&](const Theorem& now) {
                           const Theorem next = at(kept, {{n, n + 1}}, {assume(n_from_0)});
                           return linear(eq(square(n + 1), square(0)), {canonical_form(next), now});
                         }));
}
}  // namespace derivation
