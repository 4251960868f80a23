// SPDX-License-Identifier: GPL-2.0-or-later
// One collision of two bodies: from momentum and energy to the velocities after it.
#include "derivation/symbols.hpp"

namespace derivation {
void contact(Book& book) {
  book.chapter("contact", "One collision of two bodies", {lt(0, M_1), lt(0, M_2)});
  const Expr energy =
      eq(M_1 * power(u_1, 2) + M_2 * power(u_2, 2), M_1 * power(v_1, 2) + M_2 * power(v_2, 2));
  const Exprs bodies{M_1, M_2, u_1, u_2, v_1, v_2};
  const Theorem law =
      book.show("law",
                "A collision of bodies with masses M_1 and M_2 changes velocities u into v. It "
                "keeps momentum and energy, and something changes:",
                define("contact", bodies, logic_and({momentum_kept, energy, neq(v_1, u_1)}), 0));
  const Theorems laws = parts({tautology(right(law), {law, assume(fun("contact", bodies))})});
  const Theorem P = laws[0], E = laws[1], changes = laws[2];

  // M_1 (u_1 - v_1) ((u_1 + v_1) - (u_2 + v_2)) = 0, and the first two factors are not 0.
  const Theorem relative =
      book.show("relative", "Then the relative velocity turns round:",
                arithmetic(eq(u_1 + v_1, u_2 + v_2), {.equations = {{1, E}, {-(u_2 + v_2), P}},
                                                      .multipliers = {positive(M_1), changes}}));
  const Exprs after = solve({momentum_kept, relative.conclusion()}, {v_1, v_2}, {u_1, u_2});
  const Theorems rules{solved_for(v_2, relative), solved_for(M_1 * v_1, P)};
  const Theorem velocities =
      both({book.show("v_1",
                      "Together with momentum these are two linear equations, and the velocities "
                      "after the collision are",
                      equation(v_1, after[0], rules)),
            book.show("v_2", "and", equation(v_2, after[1], rules))});

  const Theorem reverse = instantiate(law, {{u_1, -v_1}, {u_2, -v_2}, {v_1, -u_1}, {v_2, -u_2}});
  const Expr back = right(reverse);
  book.show("reversed", "Run backwards in time, a collision is a collision again:",
            tautology(left(reverse), {reverse, linear(back.arg(0), {P}), linear(back.arg(1), {E}),
                                      linear(iff(eq(-u_1, -v_1), eq(v_1, u_1))), changes}));

  // The converse: with these velocities, v_1 is u_1 only where u_1 is u_2.
  const Expr alike = eq(u_1, u_2), stays = eq(v_1, u_1);
  const Theorem w_1 = assume(eq(v_1, after[0])), w_2 = assume(eq(v_2, after[1]));
  const auto where = [&](Expr f, const Theorem& t) {
    return discharge(w_1.conclusion(), discharge(f, t));
  };
  const Theorem together =
      arithmetic(alike, {.equations = {{-(M_1 + M_2) / 2, assume(stays)}, {(M_1 + M_2) / 2, w_1}},
                         .multipliers = {positive(M_2)},
                         .nonzero = {positive(M_1 + M_2)}});
  const Theorems facts{
      law, discharge(left(law), velocities), where(alike, equation(v_1, u_1, {w_1, assume(alike)})),
      where(stays, together),
      where(w_2.conclusion(), equation(logic_and({momentum_kept, energy}), {w_1, w_2}))};
  book.show(
      "exists",
      "Conversely, these velocities keep momentum and energy, and something changes where the "
      "bodies approach or part. So the law says no more than this:",
      tautology(iff(left(law), logic_and({w_1.conclusion(), w_2.conclusion(), neq(u_1, u_2)})),
                facts));
}
}  // namespace derivation
