// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 6: how many collisions there are.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

Counting counting(Kernel& kernel, const Rotation& rotation, const Power& power,
                  const Paper& paper) {
  const ex n = symbol("n"), alpha = symbol("alpha"), psi = symbol("psi");
  const ex N = symbol("N"), N_A = symbol("N_A"), N_B = symbol("N_B");

  // The approach speeds. Their size is what they are before the first such collision.
  const auto value = [&](const Theorem& velocity, long at) { return velocity.rhs().subs(n == at); };
  const ex size_A = kernel.simplified((value(power.a, 0) - value(power.c_prime, 0)) / sin(psi / 2));
  const ex size_B = kernel.simplified((value(power.c, 1) - value(power.b, 0)) / sin(psi));
  const Theorem before_P =
      kernel.rewriting({.id = "counting.before_P",
                        .statement = {a(n) - c_prime(n), size_A * sin((n + one_half) * psi)},
                        .words = "how fast A catches up with C before P_(n+1)",
                        .indices = from_zero},
                       {power.a, power.c_prime});
  const Theorem before_Q =
      kernel.rewriting({.id = "counting.before_Q",
                        .statement = {c(n + 1) - b(n), size_B * sin((n + 1) * psi)},
                        .words = "how fast C catches up with B before Q_(n+1)",
                        .indices = from_zero},
                       {power.c, power.b});

  const Theorem total =
      kernel.collision_count({.id = "counting.N",
                              .statement = {N, ceiling(2 * Pi / psi) - 1},
                              .words = "collisions go on while the next pair approaches"},
                             before_P, before_Q, n, psi / 2);
  const Theorem share_A = kernel.collisions_of({.id = "counting.share_A",
                                                .statement = {N_A, ceiling(N / 2)},
                                                .words = "A has the first, third, ..."},
                                               total);
  const Theorem share_B = kernel.collisions_of({.id = "counting.share_B",
                                                .statement = {N_B, floor(N / 2)},
                                                .words = "B has the second, fourth, ..."},
                                               total);
  const ex x = Pi / psi;
  const Theorem count_A = kernel.step_functions({.id = "counting.N_A",
                                                 .statement = paper.at("eq:NA-ans"),
                                                 .words = "the same number",
                                                 .label = "eq:NA-ans"},
                                                {share_A, total}, x);
  const Theorem count_B = kernel.step_functions({.id = "counting.N_B",
                                                 .statement = paper.at("eq:NB-ans"),
                                                 .words = "the same number",
                                                 .label = "eq:NB-ans"},
                                                {share_B, total}, x);

  // The paper's two cases, by the fractional part of pi/psi.
  const std::string label = "eq:NANB-ans, eq:NANB-ans-txt";
  const Statement above_zero{sawtooth(x), Relation::greater, 0},
      to_half{sawtooth(x), Relation::less_equal, one_half};
  const Statement above_half{sawtooth(x), Relation::greater, one_half},
      at_zero{sawtooth(x), Relation::less_equal, 0};
  kernel.step_functions({.id = "counting.equal",
                         .statement = paper.at("eq:NANB-ans, equal"),
                         .words = "N_A in the first case",
                         .label = label},
                        {count_A}, x, {above_zero, to_half});
  const Theorem equal = kernel.step_functions({.id = "counting.equal_B",
                                               .statement = {N_A, N_B},
                                               .words = "and N_B is the same",
                                               .label = label},
                                              {count_A, count_B}, x, {above_zero, to_half});
  std::vector<Theorem> one_more;
  for (const auto& [name, condition] :
       {std::pair{"above_half", above_half}, std::pair{"at_zero", at_zero}}) {
    const std::string id = std::string("counting.otherwise_") + name;
    kernel.step_functions({.id = id,
                           .statement = paper.at("eq:NANB-ans, otherwise"),
                           .words = "N_A otherwise",
                           .label = label},
                          {count_A}, x, {condition});
    one_more.push_back(kernel.step_functions({.id = id + "_B",
                                              .statement = {N_A, N_B + 1},
                                              .words = "and N_B is one less",
                                              .label = label},
                                             {count_A, count_B}, x, {condition}));
  }

  const ex slope = rotation.psi.rhs().diff(GiNaC::ex_to<GiNaC::symbol>(alpha));
  const Theorem increases =
      kernel.positivity({.id = "counting.psi_increases",
                         .statement = {slope, Relation::greater, 0},
                         .words = "psi grows with alpha: lighter balls collide more often"});
  return {before_P, before_Q,       total,          count_A,  count_B,
          equal,    one_more.at(0), one_more.at(1), increases};
}

}  // namespace magicmass::derivation
