// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 11, in part: when the collisions happen and how far apart A and B are then.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;
using GiNaC::numeric;

Times times(Kernel& kernel, const Laws& laws, const Power& power, const Counting& counting,
            const Chebyshev& chebyshev) {
  const ex n = symbol("n"), j = symbol("j"), psi = symbol("psi"), L = symbol("L"), V = symbol("V");

  const Theorem t_1 = kernel.law({.id = "times.t_1",
                                  .statement = laws.t_initial,
                                  .words = "the clock starts at the first collision"});
  const Theorem s_1 = kernel.law(
      {.id = "times.s_1", .statement = laws.s_initial, .words = "A and B are L apart then"});
  const Theorem to_B = kernel.law({.id = "times.to_B",
                                   .statement = laws.t_Q,
                                   .words = "the ball crosses from A to B",
                                   .indices = from_one});
  const Theorem gap_Q = kernel.law({.id = "times.gap_Q",
                                    .statement = laws.s_Q,
                                    .words = "meanwhile A and B move",
                                    .indices = from_one});
  const Theorem to_A = kernel.law({.id = "times.to_A",
                                   .statement = laws.t_P,
                                   .words = "the ball crosses back",
                                   .indices = from_two});
  const Theorem gap_P = kernel.law({.id = "times.gap_P",
                                    .statement = laws.s_P,
                                    .words = "meanwhile A and B move",
                                    .indices = from_two});

  // The approach speeds are known; so each crossing takes a known time ...
  const auto approach_at = [&](const char* id, const Theorem& speed, const Indices& indices) {
    const auto here = [&](const ex& e) { return e.subs(n == n - 1); };
    return kernel.instance({.id = id,
                            .statement = {here(speed.lhs()), here(speed.rhs())},
                            .words = "the approach speed, one collision earlier",
                            .indices = indices},
                           speed, {{n, n - 1}});
  };
  const Theorem towards_B = approach_at("times.towards_B", counting.before_Q, from_one);
  const Theorem towards_A = approach_at("times.towards_A", counting.before_P, from_two);
  const auto crossing = [&](const char* id, const Theorem& law, const Theorem& speed,
                            const ex& arrival, const ex& departure, const Indices& indices) {
    return kernel.consequence(
        {.id = id,
         .statement = {arrival, departure + law.rhs() / speed.rhs()},
         .words = "distance over approach speed",
         .indices = indices},
        {{law, 1 / speed.rhs()}, {speed, -(arrival - departure) / speed.rhs()}});
  };
  const Theorem at_B = crossing("times.at_B", to_B, towards_B, t_Q(n), t_P(n), from_one);
  const Theorem at_A = crossing("times.at_A", to_A, towards_A, t_P(n), t_Q(n - 1), from_two);
  // ... in which A and B move apart or together by a known distance.
  const auto separation = [&](const char* id, const Theorem& law, const Theorem& crossing_time,
                              const ex& after, const ex& before, const ex& departure,
                              const ex& arrival, const Indices& indices) {
    const ex speed = (law.rhs() / (arrival - departure)).normal();
    const ex time = crossing_time.rhs() - departure;
    return kernel.consequence({.id = id,
                               .statement = {after, before + speed * time},
                               .words = "meanwhile A and B move",
                               .indices = indices},
                              {{law, 1}, {crossing_time, speed}});
  };
  const Theorem apart_B =
      separation("times.apart_at_B", gap_Q, at_B, s_Q(n), s_P(n), t_P(n), t_Q(n), from_one);
  const Theorem apart_A =
      separation("times.apart_at_A", gap_P, at_A, s_P(n), s_Q(n - 1), t_Q(n - 1), t_P(n), from_two);

  // One cycle: t_P(n), s_P(n) from t_P(n - 1), s_P(n - 1).
  const auto recurrence = [&](const char* id, const ex& element) {
    ex written_out = element;
    for (const auto& [equation, index] : {std::pair{apart_A, n},
                                          {at_A, n},
                                          {apart_B, n - 1},
                                          {at_B, n - 1},
                                          {power.a, n - 1},
                                          {power.b, n - 1},
                                          {power.b, n - 2}})
      written_out =
          written_out.subs(equation.lhs().subs(n == index) == equation.rhs().subs(n == index));
    return kernel.rewriting({.id = id,
                             .statement = {element, written_out},
                             .words = "over one cycle",
                             .indices = from_two},
                            {apart_A, at_A, apart_B, at_B, power.a, power.b});
  };
  const Theorem t_next = recurrence("times.t_next", t_P(n));
  const Theorem s_next = recurrence("times.s_next", s_P(n));

  const auto sine = [&](const ex& multiple) { return sin(multiple * psi / 2); };
  const ex time_P = L / V * sine(2 * n - 2) / sine(2 * n - 1);
  const ex gap_at_P = L * sine(1) / sine(2 * n - 1);
  const Theorem at_P =
      kernel.induction({.id = "times.P",
                        .statement = {matrix{{t_P(n)}, {s_P(n)}}, matrix{{time_P}, {gap_at_P}}},
                        .words = "by induction over the cycles",
                        .indices = from_one},
                       {t_1, s_1}, {t_next, s_next}, n);
  const Theorem t_P_n = kernel.component({.id = "times.t_P",
                                          .statement = {t_P(n), time_P},
                                          .words = "the time of P_n",
                                          .indices = from_one},
                                         at_P, 0);
  const Theorem s_P_n = kernel.component({.id = "times.s_P",
                                          .statement = {s_P(n), gap_at_P},
                                          .words = "the distance from A to B then",
                                          .indices = from_one},
                                         at_P, 1);
  const Theorem t_Q_n =
      kernel.rewriting({.id = "times.t_Q",
                        .statement = {t_Q(n), L / V * sine(2 * n - 1) / sine(2 * n)},
                        .words = "the time of Q_n",
                        .indices = from_one},
                       {at_B, t_P_n, s_P_n});
  const Theorem s_Q_n = kernel.rewriting({.id = "times.s_Q",
                                          .statement = {s_Q(n), L * sine(1) / sine(2 * n)},
                                          .words = "the distance from A to B then",
                                          .indices = from_one},
                                         {apart_B, s_P_n, power.a, power.b});

  // All collisions counted j = 0 (P_1), 1 (Q_1), 2 (P_2), ...
  const Theorem t_j = kernel.definition({.id = "times.t",
                                         .statement = {t(j), L / V * sine(j) / sine(j + 1)},
                                         .words = "one formula for all, collisions counted from 0",
                                         .indices = j_from_zero});
  const Theorem s_j = kernel.definition({.id = "times.s",
                                         .statement = {s(j), L * sine(1) / sine(j + 1)},
                                         .words = "one formula for all",
                                         .indices = j_from_zero});
  const auto same = [&](const char* id, const ex& element, const ex& counted, const Theorem& closed,
                        const Theorem& general) {
    kernel.rewriting({.id = id,
                      .statement = {element, counted},
                      .words = "collision j is this one",
                      .indices = from_one},
                     {closed, general});
  };
  same("times.t_of_P", t_P(n), t(2 * n - 2), t_P_n, t_j);
  same("times.t_of_Q", t_Q(n), t(2 * n - 1), t_Q_n, t_j);
  same("times.s_of_P", s_P(n), s(2 * n - 2), s_P_n, s_j);
  same("times.s_of_Q", s_Q(n), s(2 * n - 1), s_Q_n, s_j);

  // sin(j h) sin h = T(1) T(j) - T(j + 1) and T(j + 2) = 2 T(1) T(j + 1) - T(j): rational functions of alpha.
  const ex below = T(j) - T(1) * T(j + 1);
  const Theorem t_rational =
      kernel.rewriting({.id = "times.t_rational",
                        .statement = {t(j), L / V * (T(1) * T(j) - T(j + 1)) / below},
                        .words = "as a rational function of alpha",
                        .indices = j_from_zero},
                       {t_j, chebyshev.T});
  const Theorem s_rational = kernel.rewriting({.id = "times.s_rational",
                                               .statement = {s(j), L * (1 - pow(T(1), 2)) / below},
                                               .words = "as a rational function of alpha",
                                               .indices = j_from_zero},
                                              {s_j, chebyshev.T});
  return {t_P_n, t_Q_n, s_P_n, s_Q_n, t_j,  s_j,   t_rational, s_rational,
          t_1,   s_1,   to_B,  gap_Q, to_A, gap_P, towards_B,  towards_A};
}

}  // namespace magicmass::derivation
