// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 12: the wedge theorem, where the collisions end.
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
using GiNaC::Pi;

Wedge wedge(Kernel& kernel, const Laws& laws, const Restitution& contact) {
  const ex n = symbol("n"), e = symbol("e"), V = symbol("V"), g = symbol("g"), h = symbol("h"),
           j = symbol("j"), L = symbol("L");
  const ex mu_A = symbol("mu_A"), mu_B = symbol("mu_B");
  const WedgeEvents events = wedge_events(kernel, laws, contact);
  const WedgeSpeeds speeds = wedge_speeds(kernel, events);
  const WedgeMotion motion = wedge_motion(kernel, laws, events, speeds);
  const std::vector<Statement> assuming{collisions_end()};

  // r_(j+1) = (1 + e) mu r_j - e r_(j-1): with the growth sqrt(e) taken out it turns by an angle each time.
  // Solved where mu_B is given by the tangent of that angle, tan_h > 0: only one root is left then.
  const ex tan_h = symbol("tan_h"), turn = atan(tan_h);
  const ex cos_h = (1 + e) / (2 * sqrt(e)) * sqrt(mu_A * mu_B);
  const ex share_of_B = 4 * e / (pow(1 + e, 2) * (1 + pow(tan_h, 2)) * mu_A);
  const Regime regime{.id = "wedge.turning_",
                      .parameters = {{mu_B, share_of_B}},
                      .g = 2 * sqrt(e) / ((1 + e) * sqrt(1 + pow(tan_h, 2)) * mu_A),
                      .sigma = [turn](const ex& k) { return sin(k * turn) / sin(turn); },
                      .assuming = {}};
  const WedgeSolution turning = wedge_solution(kernel, regime, speeds, motion);

  const ex tangent = kernel.simplified(sqrt(1 - pow(cos_h, 2)) / cos_h, {}, assuming);
  const Theorem ratio =
      kernel.definition({.id = "wedge.g",
                         .statement = {g, sqrt(mu_B / mu_A)},
                         .words = "how the speeds towards A and B differ in size"});
  const Theorem angle = kernel.definition({.id = "wedge.h",
                                           .statement = {h, atan(tangent)},
                                           .words = "the angle of the wedge",
                                           .assuming = assuming});
  kernel.identity({.id = "wedge.cos_h",
                   .statement = {cos(h), cos_h},
                   .words = "its cosine",
                   .assuming = assuming});
  // Back to the masses' shares.
  const auto in_shares = [&](const std::string& name, const Theorem& theorem, const ex& element,
                             const ex& form, const char* words) {
    return kernel.instance({.id = "wedge." + name,
                            .statement = {element, form},
                            .words = words,
                            .indices = from_one,
                            .assuming = assuming},
                           theorem, {{tan_h, tangent}});
  };
  const auto sigma = [h](const ex& k) { return sin(k * h) / sin(h); };
  const ex growth = pow(e, n - 1), unit = L / V * g / sqrt(e);
  const Theorem r_P_n = in_shares("r_P", turning.r_P, r_P(n), V * growth * sigma(2 * n - 1),
                                  "the approach speed before P_n");
  const Theorem r_Q_n =
      in_shares("r_Q", turning.r_Q, r_Q(n), V * growth * sqrt(e) / g * sigma(2 * n),
                "the approach speed before Q_n");
  const Theorem tau_P_n = in_shares("tau_P", turning.tau_P, tau_P(n),
                                    unit * sigma(2 * n - 2) / sigma(2 * n - 1), "the time of P_n");
  const Theorem tau_Q_n = in_shares("tau_Q", turning.tau_Q, tau_Q(n),
                                    unit * sigma(2 * n - 1) / sigma(2 * n), "the time of Q_n");
  const Theorem d_P_n = in_shares("d_P", turning.d_P, d_P(n), L * growth / sigma(2 * n - 1),
                                  "the distance from A to B at P_n");
  const Theorem d_Q_n =
      in_shares("d_Q", turning.d_Q, d_Q(n), L * g * growth * sqrt(e) / sigma(2 * n),
                "the distance from A to B at Q_n");
  const WedgeSolution solution{r_P_n, r_Q_n, tau_P_n, tau_Q_n, d_P_n, d_Q_n};
  const auto counted_from_0 = [&](const std::string& id, const ex& speed,
                                  const Theorem& definition) {
    return kernel.instance({.id = id + "_defined",
                            .statement = {definition.lhs().subs(n == n + 1), speed},
                            .words = "counted from 0",
                            .indices = from_zero},
                           definition, {{n, n + 1}});
  };
  const auto approach = [&](const std::string& id, const Theorem& defined, const Theorem& formula) {
    const Theorem known =
        kernel.instance({.id = id + "_known",
                         .statement = {defined.lhs(), formula.rhs().subs(n == n + 1)},
                         .words = "counted from 0",
                         .indices = from_zero,
                         .assuming = assuming},
                        formula, {{n, n + 1}});
    return kernel.consequence({.id = id,
                               .statement = {defined.rhs(), known.rhs()},
                               .words = "the approach speed of the two",
                               .indices = from_zero,
                               .assuming = assuming},
                              {{known, 1}, {defined, -1}});
  };
  const Theorem next_P = counted_from_0("wedge.before_P", v_A(n) - v_C_prime(n), speeds.r_P),
                next_Q = counted_from_0("wedge.before_Q", v_C(n + 1) - v_B(n), speeds.r_Q);
  const Theorem before_P = approach("wedge.before_P", next_P, solution.r_P);
  const Theorem before_Q = approach("wedge.before_Q", next_Q, solution.r_Q);
  const Theorem count =
      kernel.collision_count({.id = "wedge.N_C",
                              .statement = {N_C(), ceiling(Pi / h) - 1},
                              .words = "collisions go on while the next pair approaches",
                              .assuming = assuming},
                             before_P, before_Q, n, h);
  const WedgeTheorem theorem{speeds.r_P,   speeds.r_Q, ratio,    angle,    solution.r_P,
                             solution.r_Q, next_P,     before_P, before_Q, count};
  const WedgeVelocities velocities = wedge_velocities(kernel, events, theorem);

  const Theorem all_times =
      kernel.definition({.id = "wedge.tau",
                         .statement = {tau(j), L / V * g / sqrt(e) * sin(j * h) / sin((j + 1) * h)},
                         .words = "one formula for all times, collisions counted from 0",
                         .indices = {{"j", 0}},
                         .assuming = assuming});
  const auto same = [&](const char* id, const ex& element, const ex& counted,
                        const Theorem& closed) {
    kernel.rewriting({.id = id,
                      .statement = {element, counted},
                      .words = "collision j is this one",
                      .indices = from_one,
                      .assuming = assuming},
                     {closed, all_times});
  };
  same("wedge.tau_of_P", tau_P(n), tau(2 * n - 2), solution.tau_P);
  same("wedge.tau_of_Q", tau_Q(n), tau(2 * n - 1), solution.tau_Q);
  return {events, speeds, motion, theorem, solution, velocities, all_times};
}

}  // namespace magicmass::derivation
