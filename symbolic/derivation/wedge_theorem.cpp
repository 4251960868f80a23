// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 12: the wedge theorem, where the collisions end.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "derivation/wedge.hpp"
#include "proof/families.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::Pi;

Wedge wedge(Kernel& kernel, const Laws& laws, const Restitution& contact) {
  const std::map<std::string, long> from_zero{{"n", 0}}, from_one{{"n", 1}};
  const ex n = symbol("n"), e = symbol("e"), V = symbol("V"), g = symbol("g"), h = symbol("h");
  const ex mu_A = symbol("mu_A"), mu_B = symbol("mu_B");
  const WedgeEvents events = wedge_events(kernel, laws, contact);
  const WedgeSpeeds speeds = wedge_speeds(kernel, events);
  const std::vector<Statement> assuming{collisions_end()};

  // r_(j+1) = (1 + e) mu r_j - e r_(j-1): with the growth sqrt(e) taken out it turns by h each time.
  const ex cos_h = (1 + e) / (2 * sqrt(e)) * sqrt(mu_A * mu_B);
  const Theorem ratio =
      kernel.definition({.id = "wedge.g",
                         .statement = {g, sqrt(mu_B / mu_A)},
                         .words = "how the speeds towards A and B differ in size"});
  const Theorem angle = kernel.definition(
      {.id = "wedge.h",
       .statement = {h, atan(kernel.simplified(sqrt(1 - pow(cos_h, 2)) / cos_h, {}, assuming))},
       .words = "the angle of the wedge",
       .assuming = assuming});
  kernel.identity({.id = "wedge.cos_h",
                   .statement = {cos(h), cos_h},
                   .words = "its cosine",
                   .assuming = assuming});

  const matrix sequences{{r_P(n)}, {r_Q(n)}};
  const matrix formulas{{V * pow(e, n - 1) * sin((2 * n - 1) * h) / sin(h)},
                        {V * pow(e, n - 1) * sqrt(e) / g * sin(2 * n * h) / sin(h)}};
  const Theorem closed =
      kernel.induction({.id = "wedge.r",
                        .statement = {sequences, formulas},
                        .words = "by induction over the cycles",
                        .indices = from_one,
                        .assuming = assuming},
                       {speeds.first_P, speeds.first_Q}, {speeds.next_P, speeds.cycle_Q}, n);
  const auto component = [&](const char* id, unsigned row, const char* words) {
    return kernel.component({.id = id,
                             .statement = {sequences(row, 0), formulas(row, 0)},
                             .words = words,
                             .indices = from_one,
                             .assuming = assuming},
                            closed, row);
  };
  const Theorem before_P = component("wedge.r_P", 0, "approach speeds before P_n");
  const Theorem before_Q = component("wedge.r_Q", 1, "approach speeds before Q_n");
  const auto approach = [&](const char* id, const ex& speed, const Theorem& definition,
                            const Theorem& formula) {
    const Theorem defined = kernel.instance({.id = std::string(id) + "_defined",
                                             .statement = {definition.lhs().subs(n == n + 1), speed},
                                             .words = "counted from 0",
                                             .indices = from_zero},
                                            definition, {{n, n + 1}});
    const Theorem known = kernel.instance(
        {.id = std::string(id) + "_known",
         .statement = {defined.lhs(), formula.rhs().subs(n == n + 1)},
         .words = "counted from 0",
         .indices = from_zero,
         .assuming = assuming},
        formula, {{n, n + 1}});
    return kernel.consequence({.id = id,
                               .statement = {speed, known.rhs()},
                               .words = "the approach speed of the two",
                               .indices = from_zero,
                               .assuming = assuming},
                              {{known, 1}, {defined, -1}});
  };
  const Theorem count = kernel.collision_count(
      {.id = "wedge.N_C",
       .statement = {N_C(), ceiling(Pi / h) - 1},
       .words = "collisions go on while the next pair approaches",
       .assuming = assuming},
      approach("wedge.before_P", v_A(n) - v_C_prime(n), speeds.r_P, before_P),
      approach("wedge.before_Q", v_C(n + 1) - v_B(n), speeds.r_Q, before_Q), n, h);
  static_cast<void>(ratio);
  static_cast<void>(angle);
  static_cast<void>(count);
  return {events, speeds, ratio, angle, before_P, before_Q, count};
}

}  // namespace magicmass::derivation
