// Collisions that lose energy, and the motion of three bodies of any masses from any start: how
// fast the two of each collision approach before it.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
const Expr w_2 = real("w_2");
const Expr relative = eq(v_2 - v_1, e*(u_1 - u_2));
/// With the inverse mass of the second body.
const Expr shared = eq(w_2 * M_1 * u_1 + u_2, w_2* M_1* v_1 + v_2);
/// The velocities after a collision with restitution e, solved for.
Exprs solved(Expr law) { return solve({law, relative}, {v_1, v_2}, {u_1, u_2}); }

void one_collision(Book& book) {
  const Exprs bodies{e, M_1, M_2, u_1, u_2, v_1, v_2};
  const Theorem law = book.show(
      "law",
      "A collision with restitution e keeps momentum, and the bodies part e times as fast "
      "as they approached:",
      define("impact", bodies, logic_and({momentum_kept, relative}), 0));
  const Theorems laws = parts({tautology(right(law), {law, assume(left(law))})});
  const Exprs after = solved(momentum_kept);
  const Theorems v_is{solved_for(v_2, laws[1]), solved_for(M_1 * v_1, laws[0])};
  book.show("v_1", "The velocities after it are", equation(v_1, after[0], v_is));
  book.show("v_2", "and", equation(v_2, after[1], v_is));
  const Expr lost =
      M_1 * power(u_1, 2) + M_2 * power(u_2, 2) - M_1 * power(v_1, 2) - M_2 * power(v_2, 2);
  book.show(
      "energy", "Twice the kinetic energy that is lost:",
      equation(lost, (1 - power(e, 2)) * M_1 * M_2 / (M_1 + M_2) * power(u_1 - u_2, 2), v_is));
  // What divides by M_2 serves a wall, too.
  const Theorem wall =
      book.show("wall", "A wall stays as it is:",
                define("rebound", {e, u_1, u_2, v_1, v_2}, logic_and({eq(v_2, u_2), relative}), 0));
  const Theorems of_wall = parts({tautology(right(wall), {wall, assume(left(wall))})});
  const Exprs of_both = solved(shared);
  const auto instance = [&](Expr value, const Theorems& rules, const auto& shape) {
    const auto is = [&](Expr v, std::size_t i) {
      return equation(v, shape(substitute(of_both[i], {{w_2, value}})), rules);
    };
    return both({is(v_1, 0), is(v_2, 1)});
  };
  book.show("inverse_mass", "With 1/M_2 for M_2 the velocities are",
            instance(1 / M_2, v_is, [](Expr t) { return t; }));
  book.show("at_wall", "and with 0 for 1/M_2 those of a wall:",
            instance(0, {solved_for(v_1, of_wall[1]), of_wall[0]}, [](Expr t) {
              return simplified(t, {u_1, u_2});
            }));
}
/// The approach speed before collision j, and its recurrence.
void recurrence(Book& book, const Theorems& motion) {
  const Theorems turns = parts({book["cycle.turn"]});
  const Theorem square = book["cycle.turn_squared"];
  const Theorem definition =
      book.name("nearing", any_start() + Exprs{j},
                is_P(j) * (any_velocity("A", j) - any_velocity("C", j)) +
                    is_Q(j) * (any_velocity("C", j) - any_velocity("B", j)),
                of_wedge({le(0, j)}), "Before collision j its two bodies approach with the speed",
                "", "closing");
  Theorems step{definition, at(turns[1]), square};
  for (std::size_t i = 3; i < 6; ++i) step.push_back(at(motion[i]));
  const Expr next = j + 1, from_P = (1 + e) / (M_A + M_C), from_Q = (1 + e) / (1 + w_B * M_C);
  Theorems changes;
  for (const auto& [body, share] :
       {std::pair{"A", -(is_P(j) * (M_C * from_P))}, std::pair{"B", is_Q(j) * (w_B * M_C * from_Q)},
        std::pair{"C", is_P(j) * (M_A * from_P) - is_Q(j) * from_Q}})
    changes.push_back(
        equation(any_velocity(body, next), any_velocity(body, j) + share * nearing(j), step));
  book.show("changes", "which changes velocities by shares of it:", both(changes));
  const Theorem closes = at(definition, {{j, next}});
  const auto other = [&](Expr i) {  // of the two that collide next
    return is_Q(i) * (any_velocity("A", i) - any_velocity("C", i)) +
           is_P(i) * (any_velocity("C", i) - any_velocity("B", i));
  };
  const Theorem parting = book.show("parting", "They part e times as fast as they approached:",
                                    equation(other(next), -e * nearing(j), step));
  const auto share = [](Expr i) {
    return is_P(i) * (M_A / (M_A + M_C)) + is_Q(i) * (1 / (1 + w_B * M_C));
  };
  const Theorem gain =
      equation(nearing(next), other(j) + (1 + e) * share(j) * nearing(j), step + Theorems{closes});
  const Theorems start{motion[0], motion[1], motion[2], turns[0], at(definition, {{j, 0}})};
  const Theorem second = equation(nearing(Expr(0) + 1), W + (1 + e) * (M_A / (M_A + M_C)) * V,
                                  Theorems{at(gain, {{j, 0}})} + start);
  book.show("first", "The first two speeds are",
            both({equation(nearing(0), V, start), restate(eq(nearing(1), right(second)), second)}));
  const auto carried = [&](Expr i) {  // the momentum, times w_B
    return w_B * (M_A * any_velocity("A", i) + M_C * any_velocity("C", i)) + any_velocity("B", i);
  };
  const Theorem momentum =
      book.show("momentum", "Momentum is kept, if there is no wall:",
                by_induction(j, eq(carried(j), any_momentum()),
                             equation(carried(0), any_momentum(), start), [&](const Theorem& now) {
                               return chain(equation(carried(next), carried(j), changes), now);
                             }));
  // The two speeds after collision j, by the one before it and the one before the next.
  const Theorem parts_with = solved_for(e * nearing(j), parting);
  const Expr A = any_velocity("A", next), B = any_velocity("B", next), C = any_velocity("C", next);
  const Expr of_A = nearing(next) - e * nearing(j), all = mass_of_all();
  const Expr of_B = is_Q(next) * nearing(next) - is_P(next) * (e * nearing(j));
  const Theorem A_B = book.show("A_B", "After collision j the velocities of A and B differ by",
                                linear(eq(A - B, of_A), {closes, parting}));
  const Theorem C_B =
      book.show("C_B", "those of C and B by",
                equation(C - B, of_B, {closes, parts_with, at(square, {{j, next}})}));
  const Expr given_off = any_momentum() - w_B * (M_A * of_A + M_C * of_B);
  const Theorem of_one = rewrite(solved_for(A, A_B), at(momentum, {{j, next}}));
  const Theorem whole = linear(eq(B * all, given_off), {rewrite(solved_for(C, C_B), of_one)});
  book.show("B_velocity", "and B has", divided(B, all, whole));
  book.show("recurrence", "and each one follows from two before:",
            linear(eq(nearing(j + 2), (1 + e) * share(next) * nearing(next) - e * nearing(j)),
                   {at(gain, {{j, next}}), parting}));
}
}  // namespace

void sequences(Book& book) {
  const Exprs of_masses = solved(momentum_kept), of_inverse = solved(shared);
  const auto of_A = [&](std::size_t body, Expr u, Expr other) {
    return substitute(of_masses[body], {{M_1, M_A}, {M_2, M_C}, {u_1, u}, {u_2, other}});
  };
  const auto of_B = [&](std::size_t body, Expr u, Expr other) {
    return substitute(of_inverse[body], {{M_1, M_C}, {w_2, w_B}, {u_1, u}, {u_2, other}});
  };
  const Expr P = is_P(j), Q = is_Q(j);
  const auto next = [&](const Exprs& before) {
    const Expr A = before[0], B = before[1], C = before[2];
    return Exprs{P * of_A(0, A, C) + Q * A, P * B + Q * of_B(1, C, B),
                 P * of_A(1, A, C) + Q * of_B(0, C, B)};
  };
  const Theorems motion = defined_by_recursion({"any_A", "any_B", "any_C"}, any_start(), j,
                                               of_wedge({le(0, j)}), {V + W, 0, W}, next);
  book.show("start",
            "At the start A approaches the ball with V and the ball B with W, seen from B; w_B is "
            "1/M_B for a block and 0 for a wall:",
            both({motion[0], motion[1], motion[2]}));
  book.show("next", "Collision j is one of A and C, or of C and B, by turns:",
            both({motion[3], motion[4], motion[5]}));
  recurrence(book, motion);
}
void restitution(Book& book) {
  book.chapter("restitution", "Any masses, and collisions that lose energy",
               {lt(0, M_1), lt(0, M_2)});
  one_collision(book);
}
}  // namespace derivation
