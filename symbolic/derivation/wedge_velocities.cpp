// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 12: all four velocities of the wedge, from total momentum and two relative velocities.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "derivation/shorthand.hpp"
#include "derivation/wedge.hpp"
#include "proof/families.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;

WedgeVelocities wedge_velocities(Kernel& kernel, const WedgeEvents& events,
                                 const WedgeTheorem& theorem) {
  const std::vector<Statement> assuming{collisions_end()};
  const ex n = symbol("n"), e = symbol("e"), V = symbol("V"), g = symbol("g"), h = symbol("h");
  const ex mu_A = symbol("mu_A"), mu_B = symbol("mu_B");

  // Masses M_A : M_B : m in shares, with no division by 1 - mu_B, which a wall has not.
  const ex w_A = mu_A * (1 - mu_B), w_B = mu_B * (1 - mu_A), w_C = (1 - mu_A) * (1 - mu_B);
  const ex total = w_A * v_A(n) + w_B * v_B(n) + w_C * v_C_prime(n);
  const Theorem sum = kernel.definition({.id = "wedge.momentum",
                                         .statement = {p(n), total},
                                         .words = "total momentum after Q_n, up to a factor",
                                         .indices = from_zero});
  const Theorem at_0 = kernel.rewriting({.id = "wedge.momentum_0",
                                         .statement = {p(0), w_A * events.a_0.rhs()},
                                         .words = "at first A has all of it"},
                                        {sum, events.a_0, events.b_0, events.c_0});
  const Theorem next =
      kernel.rewriting({.id = "wedge.momentum_next",
                        .statement = {p(n), p(n - 1)},
                        .words = "no collision changes it",
                        .indices = from_one},
                       {sum, events.after_B, events.after_C_prime, events.after_A, events.after_C});
  const Theorem conserved = kernel.induction({.id = "wedge.momentum_conserved",
                                              .statement = {p(n), w_A * V},
                                              .words = "so it never changes",
                                              .indices = from_zero},
                                             {at_0}, {next}, n);

  // After Q_n: A and the ball approach with y, B and the ball separate with x.
  const ex growth = V * pow(e, n) / sin(h);
  const ex y = growth * sin((2 * n + 1) * h), x = growth * sqrt(e) / g * sin(2 * n * h);
  const ex apart = v_B(n) - v_C_prime(n);
  const Theorem at_Q_0 = kernel.rewriting({.id = "wedge.apart_0",
                                           .statement = {apart.subs(n == 0), x.subs(n == 0)},
                                           .words = "at first B and the ball are at rest",
                                           .assuming = assuming},
                                          {events.b_0, events.c_0});
  const Theorem at_Q = kernel.rewriting({.id = "wedge.apart_later",
                                         .statement = {e * r_Q(n), x},
                                         .words = "e of the approach speed is left",
                                         .indices = from_one,
                                         .assuming = assuming},
                                        {theorem.r_Q});
  const Theorem later =
      kernel.rewriting({.id = "wedge.apart_restitution",
                        .statement = {apart, e * r_Q(n)},
                        .words = "restitution at Q_n",
                        .indices = from_one},
                       {theorem.r_Q_definition, events.after_B, events.after_C_prime});
  const Theorem later_closed = kernel.consequence({.id = "wedge.apart_closed",
                                                   .statement = {apart, x},
                                                   .words = "in closed form",
                                                   .indices = from_one,
                                                   .assuming = assuming},
                                                  {{later, 1}, {at_Q, 1}});
  const Theorem apart_n = kernel.first_and_later({.id = "wedge.apart",
                                                  .statement = {apart, x},
                                                  .words = "how fast B and the ball separate",
                                                  .indices = from_zero,
                                                  .assuming = assuming},
                                                 at_Q_0, later_closed, n);

  // Three linear equations for three velocities: from the approach speeds, whatever these are, and in closed form.
  const LinearSolution solution = solve_linear(
      {{total, w_A * V}, {v_A(n) - v_C_prime(n), y}, {apart, x}}, {v_A(n), v_B(n), v_C_prime(n)});
  const ex one = 1 - mu_A * mu_B;  // the masses' sum, in shares
  const ex centre = w_A * V;
  const auto forms = [&](const ex& towards, const ex& away) {
    return std::vector<ex>{(centre + (1 - mu_A) * (towards - mu_B * away)) / one,
                           (centre + (1 - mu_B) * (away - mu_A * towards)) / one,
                           (w_A * (V - towards) - w_B * away) / one};
  };
  const std::vector<std::pair<const char*, ex>> elements{
      {"wedge.v_A", v_A(n)}, {"wedge.v_B", v_B(n)}, {"wedge.v_C_prime", v_C_prime(n)}};
  const auto velocity = [&](const std::string& suffix, size_t which, const ex& form,
                            const Theorem& towards, const Theorem& away, const Indices& indices,
                            const std::vector<Statement>& where) {
    const auto cofactor = [&](size_t equation) {
      return kernel.simplified(solution.cofactors[which][equation], indices);
    };
    return kernel.consequence({.id = elements[which].first + suffix,
                               .statement = {elements[which].second, form},
                               .words = "three linear equations, solved",
                               .indices = indices,
                               .assuming = where},
                              {{conserved, cofactor(0)},
                               {sum, -cofactor(0)},
                               {towards, cofactor(1)},
                               {away, cofactor(2)}});
  };
  const Theorem towards = kernel.consequence({.id = "wedge.towards",
                                              .statement = {v_A(n) - v_C_prime(n), r_P(n + 1)},
                                              .words = "A and the ball approach",
                                              .indices = from_zero},
                                             {{theorem.next_P_defined, -1}});
  const std::vector<ex> by_speeds = forms(r_P(n + 1), e * r_Q(n)), closed = forms(y, x);
  const auto from_speeds = [&](size_t which) {
    return velocity("_from_speeds", which, by_speeds[which], towards, later, from_one, {});
  };
  const auto in_closed_form = [&](size_t which) {
    return velocity("", which, closed[which], theorem.before_P, apart_n, from_zero, assuming);
  };
  const Theorem speeds_A = from_speeds(0), speeds_B = from_speeds(1), speeds_C = from_speeds(2);
  const Theorem of_A = in_closed_form(0), of_B = in_closed_form(1), of_C_prime = in_closed_form(2);
  // The ball after P_n: e of what it was before is left between A and it.
  const Theorem from_A = kernel.rewriting({.id = "wedge.v_C_from_A",
                                           .statement = {v_C(n), v_A(n) + e * r_P(n)},
                                           .words = "restitution at P_n",
                                           .indices = from_one},
                                          {theorem.r_P_definition, events.after_A, events.after_C});
  const ex y_before = growth * sin((2 * n - 1) * h);
  const Theorem of_C = kernel.rewriting({.id = "wedge.v_C",
                                         .statement = {v_C(n), closed[0] + y_before},
                                         .words = "the ball after P_n",
                                         .indices = from_one,
                                         .assuming = assuming},
                                        {from_A, of_A, theorem.r_P});

  // B keeps what its last collision gave it, and that is its floor(N_C/2)-th.
  const ex k = symbol("k");
  const Theorem last = kernel.hypothesis({.id = "wedge.last_of_B",
                                          .statement = {k, floor(N_C() / 2)},
                                          .words = "the number of collisions of B",
                                          .indices = k_from_zero});
  const Theorem of_B_last = kernel.instance({.id = "wedge.v_B_last",
                                             .statement = {v_B(k), of_B.rhs().subs(n == k)},
                                             .words = "B after its k-th collision",
                                             .indices = k_from_zero,
                                             .assuming = assuming},
                                            of_B, {{n, k}});
  kernel.rewriting({.id = "wedge.rho",
                    .statement = {pow(v_B(k) / V, 2), pow(of_B_last.rhs() / V, 2)},
                    .words = "the fraction rho of the energy that reaches B",
                    .indices = k_from_zero,
                    .assuming = assuming},
                   {of_B_last, last});
  return {of_A, of_B, of_C, of_C_prime, speeds_A, speeds_B, speeds_C, from_A};
}

}  // namespace magicmass::derivation
