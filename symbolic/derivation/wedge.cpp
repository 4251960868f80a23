// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 12: any three masses and any restitution, as one wedge of angle h: approach speeds and counts.
#include "derivation/wedge.hpp"

#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "derivation/shorthand.hpp"
#include "proof/families.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

std::set<std::string> any_wedge() { return {"mu_A", "mu_B", "e"}; }

Statement collisions_end() {
  const ex e = symbol("e");
  return {4 * e, Relation::greater, pow(1 + e, 2) * symbol("mu_A") * symbol("mu_B")};
}

// Momentum over total mass, mu u_1 + (1 - mu) u_2, at P_n and Q_n: for blocks from the momentum law, and for
// a wall, mu_B = 1, from its own.
WedgeEvents wedge_events(Kernel& kernel, const Laws& laws, const Restitution& contact) {
  const ex n = symbol("n"), m = symbol("m"), M_A = symbol("M_A"), M_B = symbol("M_B");
  const ex mu_A = symbol("mu_A"), mu_B = symbol("mu_B");
  const ex u_1 = symbol("u_1"), u_2 = symbol("u_2"), v_1 = symbol("v_1"), v_2 = symbol("v_2");
  const Kernel::Values at_P{
      {u_1, v_A(n - 1)}, {u_2, v_C_prime(n - 1)}, {v_1, v_A(n)}, {v_2, v_C(n)}};
  const Kernel::Values at_Q{{u_1, v_B(n - 1)}, {u_2, v_C(n)}, {v_1, v_B(n)}, {v_2, v_C_prime(n)}};
  const auto put_in = [](const Statement& statement, const Kernel::Values& values) {
    GiNaC::exmap replacements;
    for (const auto& [name, value] : values) replacements[name] = value;
    return Statement(statement.lhs().subs(replacements), statement.rhs().subs(replacements));
  };
  const auto special = [&](const std::string& id, const Theorem& law, const Kernel::Values& values,
                           const char* words) {
    return kernel.instance({.id = id,
                            .statement = put_in(law.statement(), values),
                            .words = words,
                            .indices = from_one},
                           law, values);
  };
  const Theorem wall = kernel.law({.id = "wedge.wall",
                                   .statement = laws.wall,
                                   .words = "a wall does not move in a contact",
                                   .schematic = {"M_1", "M_2", "u_1", "u_2", "v_1", "v_2", "e"}});

  const auto momentum = [&](const std::string& id, const Kernel::Values& values, const ex& mu,
                            const ex& M, bool or_wall) {
    const Statement general{mu * values[0].second + (1 - mu) * values[1].second,
                            mu * values[2].second + (1 - mu) * values[3].second};
    const auto at = [&](const ex& share) { return put_in(general, {{mu, share}}); };
    const ex share = M / (M + m);
    Kernel::Values of_block{{symbol("M_1"), M}, {symbol("M_2"), m}};
    for (const auto& [name, value] : values) of_block.emplace_back(name, value.subs(mu == share));
    const Theorem with_masses =
        special(id + "_masses", contact.momentum, of_block, "momentum, here");
    const Theorem block = kernel.consequence({.id = id + "_block",
                                              .statement = at(share),
                                              .words = "divided by the mass of both",
                                              .indices = from_one},
                                             {{with_masses, 1 / (M + m)}});
    std::vector<std::pair<Kernel::Values, Theorem>> all{{{{mu, share}}, block}};
    if (or_wall) {
      Kernel::Values of_wall;
      for (const auto& [name, value] : values) of_wall.emplace_back(name, value.subs(mu == 1));
      const Theorem still = special(id + "_still", wall, of_wall, "the wall, here");
      const Theorem at_wall = kernel.consequence({.id = id + "_wall",
                                                  .statement = at(1),
                                                  .words = "a wall has all of the mass",
                                                  .indices = from_one},
                                                 {{still, -1}});
      all.push_back({{{mu, ex(1)}}, at_wall});
    }
    return kernel.cases({.id = id,
                         .statement = general,
                         .words = "momentum over the mass of both",
                         .indices = from_one},
                        all);
  };
  const Theorem momentum_P = momentum("wedge.momentum_P", at_P, mu_A, M_A, false);
  const Theorem momentum_Q = momentum("wedge.momentum_Q", at_Q, mu_B, M_B, true);
  const Theorem restitution_P =
      special("wedge.restitution_P", contact.restitution, at_P, "restitution at P_n");
  const Theorem restitution_Q =
      special("wedge.restitution_Q", contact.restitution, at_Q, "restitution at Q_n");

  const auto initial = [&](const char* id, const Statement& law, const ex& elastic,
                           const ex& family, const char* words) {
    return kernel.law({.id = id,
                       .statement = {law.lhs().subs(elastic == family), law.rhs()},
                       .words = words,
                       .schematic = any_wedge()});
  };
  const Theorem a_0 =
      initial("wedge.v_A_0", laws.a_initial, a(0), v_A(0), "A comes with velocity V");
  const Theorem b_0 = initial("wedge.v_B_0", laws.b_initial, b(0), v_B(0), "B is at rest");
  const Theorem c_0 =
      initial("wedge.v_C_0", laws.c_initial, c_prime(0), v_C_prime(0), "so is the ball");

  // Solved for the velocities after each collision.
  const auto solved = [&](const char* id_block, const char* id_ball, const Theorem& first,
                          const Theorem& second, const ex& block, const ex& ball) {
    const LinearSolution solution =
        solve_linear({first.statement(), second.statement()}, {block, ball});
    const auto one = [&](const char* id, size_t which, const ex& unknown) {
      return kernel.consequence(
          {.id = id,
           .statement = {unknown, kernel.simplified(solution.values[which], from_one)},
           .words = "solved for the velocity after",
           .indices = from_one},
          {{first, kernel.simplified(solution.cofactors[which][0], from_one)},
           {second, kernel.simplified(solution.cofactors[which][1], from_one)}});
    };
    return std::pair{one(id_block, 0, block), one(id_ball, 1, ball)};
  };
  const auto [after_A, after_C] =
      solved("wedge.after_A", "wedge.after_C", momentum_P, restitution_P, v_A(n), v_C(n));
  const auto [after_B, after_C_prime] = solved("wedge.after_B", "wedge.after_C_prime", momentum_Q,
                                               restitution_Q, v_B(n), v_C_prime(n));
  return {wall, momentum_P, momentum_Q, restitution_P, restitution_Q, a_0,
          b_0,  c_0,        after_A,    after_C,       after_B,       after_C_prime};
}

WedgeSpeeds wedge_speeds(Kernel& kernel, const WedgeEvents& events) {
  const ex n = symbol("n"), e = symbol("e"), mu_A = symbol("mu_A"), mu_B = symbol("mu_B");
  const Theorem r_P_n = kernel.definition({.id = "wedge.approach_P",
                                           .statement = {r_P(n), v_A(n - 1) - v_C_prime(n - 1)},
                                           .words = "how fast A catches up with C before P_n",
                                           .indices = from_one});
  const Theorem r_Q_n = kernel.definition({.id = "wedge.approach_Q",
                                           .statement = {r_Q(n), v_C(n) - v_B(n - 1)},
                                           .words = "how fast C catches up with B before Q_n",
                                           .indices = from_one});
  const std::vector<Theorem> over_a_cycle{
      r_P_n,          r_Q_n,          events.after_C, events.after_C_prime,
      events.after_B, events.after_A, events.after_C};
  const Theorem next_P =
      kernel.rewriting({.id = "wedge.next_P",
                        .statement = {r_P(n), (1 + e) * mu_B * r_Q(n - 1) - e * r_P(n - 1)},
                        .words = "the approach speed before P_n from the two before it",
                        .indices = from_two},
                       over_a_cycle);
  const Theorem next_Q =
      kernel.rewriting({.id = "wedge.next_Q",
                        .statement = {r_Q(n), (1 + e) * mu_A * r_P(n) - e * r_Q(n - 1)},
                        .words = "the approach speed before Q_n from the two before it",
                        .indices = from_two},
                       over_a_cycle);
  const Theorem cycle_Q =
      kernel.rewriting({.id = "wedge.cycle_Q",
                        .statement = {r_Q(n), next_Q.rhs().subs(r_P(n) == next_P.rhs()).expand()},
                        .words = "from those a cycle earlier",
                        .indices = from_two},
                       {next_Q, next_P});
  const std::vector<Theorem> at_start{r_P_n,      r_Q_n,      events.after_C,
                                      events.a_0, events.b_0, events.c_0};
  const Theorem first_P = kernel.rewriting({.id = "wedge.first_P",
                                            .statement = {r_P(1), events.a_0.rhs()},
                                            .words = "A approaches with V"},
                                           at_start);
  const Theorem first_Q =
      kernel.rewriting({.id = "wedge.first_Q",
                        .statement = {r_Q(1), (1 + e) * mu_A * events.a_0.rhs()},
                        .words = "and the ball leaves with this"},
                       at_start);
  return {r_P_n, r_Q_n, first_P, first_Q, next_P, next_Q, cycle_Q};
}

}  // namespace magicmass::derivation
