// SPDX-License-Identifier: GPL-2.0-or-later
// Collisions that lose energy, of two bodies of any masses or of one and a wall.
#include "derivation/wedge.hpp"

namespace derivation {
namespace {
const Expr w_2 = real("w_2");
const Expr relative = eq(v_2 - v_1, e*(u_1 - u_2));
/// With the inverse mass of the second body.
const Expr shared = eq(w_2 * M_1 * u_1 + u_2, w_2* M_1* v_1 + v_2);
/// The velocities after a collision with restitution e, solved for.
Exprs solved(Expr law) { return solve({law, relative}, {v_1, v_2}, {u_1, u_2}); }

}  // namespace

void restitution(Book& book) {
  book.chapter("restitution", "Any masses, and collisions that lose energy",
               {lt(0, M_1), lt(0, M_2)});
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
}  // namespace derivation
