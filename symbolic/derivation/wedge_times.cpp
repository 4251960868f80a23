// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 12: approach speeds, times and distances of the wedge in closed form, in each of its regimes.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "derivation/wedge.hpp"
#include "proof/families.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::matrix;

namespace {

// The elastic chapters' laws of motion, for the wedge's sequences.
Statement for_wedge(const Statement& law) {
  const ex n = symbol("n");
  const GiNaC::exmap renamed{
      {a(n), v_A(n)},           {a(n - 1), v_A(n - 1)}, {b(n), v_B(n)},
      {b(n - 1), v_B(n - 1)},   {c(n), v_C(n)},         {c_prime(n - 1), v_C_prime(n - 1)},
      {t_P(n), tau_P(n)},       {t_Q(n), tau_Q(n)},     {t_Q(n - 1), tau_Q(n - 1)},
      {t_P(1), tau_P(1)},       {s_P(n), d_P(n)},       {s_Q(n), d_Q(n)},
      {s_Q(n - 1), d_Q(n - 1)}, {s_P(1), d_P(1)}};
  return {law.lhs().subs(renamed), law.rhs().subs(renamed)};
}

}  // namespace

// Approach speed times time, r_j tau_j =: x_j, is the gap that the flight would have had at time 0. As speeds do, it
// obeys x_(j+1) = (1 + e) mu x_j - e x_(j-1); and r_j d_j =: D_j loses a factor e each time.
WedgeMotion wedge_motion(Kernel& kernel, const Laws& laws, const WedgeEvents& events,
                         const WedgeSpeeds& speeds) {
  const ex n = symbol("n"), e = symbol("e"), L = symbol("L");
  const ex mu_A = symbol("mu_A"), mu_B = symbol("mu_B");
  const auto law = [&](const char* id, const Statement& elastic, const char* words,
                       const Indices& indices) {
    return kernel.law({.id = id,
                       .statement = for_wedge(elastic),
                       .words = words,
                       .indices = indices,
                       .schematic = any_wedge()});
  };
  const Theorem t_1 =
      law("wedge.tau_1", laws.t_initial, "the clock starts at the first collision", {});
  const Theorem d_1 = law("wedge.d_1", laws.s_initial, "A and B are L apart then", {});
  const Theorem to_B = law("wedge.to_B", laws.t_Q, "the ball crosses from A to B", from_one);
  const Theorem gap_Q = law("wedge.gap_Q", laws.s_Q, "meanwhile A and B move", from_one);
  const Theorem to_A = law("wedge.to_A", laws.t_P, "the ball crosses back", from_two);
  const Theorem gap_P = law("wedge.gap_P", laws.s_P, "meanwhile A and B move", from_two);

  const auto combined = [&](const std::string& id, const Statement& statement, const char* words,
                            const Indices& indices, const Kernel::Combination& premises) {
    return kernel.consequence(
        {.id = id, .statement = statement, .words = words, .indices = indices}, premises);
  };
  const auto at = [&](const std::string& id, const Theorem& general, const ex& index,
                      const Indices& indices) {
    const auto here = [&](const ex& side) { return side.subs(n == index); };
    return kernel.instance({.id = id,
                            .statement = {here(general.lhs()), here(general.rhs())},
                            .words = index.is_equal(1) ? "at the start" : "one cycle earlier",
                            .indices = indices},
                           general, {{n, index}});
  };
  const auto earlier = [&](const std::string& id, const Theorem& general) {
    return at(id + "_earlier", general, n - 1, from_two);
  };
  const ex time_Q = tau_Q(n) - tau_P(n), time_P = tau_P(n) - tau_Q(n - 1);
  const Theorem speed_Q_earlier = earlier("wedge.approach_Q", speeds.r_Q);
  const Theorem restitution_Q_earlier = earlier("wedge.restitution_Q", events.restitution_Q);
  const Theorem crossing_Q = combined("wedge.crossing_Q", {r_Q(n) * time_Q, d_P(n)},
                                      "approach speed times time is distance", from_one,
                                      {{to_B, 1}, {speeds.r_Q, time_Q}});
  const Theorem crossing_P = combined("wedge.crossing_P", {r_P(n) * time_P, d_Q(n - 1)},
                                      "approach speed times time is distance", from_two,
                                      {{to_A, 1}, {speeds.r_P, time_P}});
  const Theorem opening_Q =
      combined("wedge.opening_Q", {d_Q(n), e * r_P(n) * time_Q},
               "A and the ball separate with e of their approach speed", from_one,
               {{gap_Q, 1},
                {crossing_Q, -1},
                {speeds.r_Q, time_Q},
                {events.restitution_P, time_Q},
                {speeds.r_P, -e * time_Q}});
  const Theorem opening_P =
      combined("wedge.opening_P", {d_P(n), e * r_Q(n - 1) * time_P},
               "the ball and B separate with e of their approach speed", from_two,
               {{gap_P, 1},
                {crossing_P, -1},
                {speeds.r_P, time_P},
                {restitution_Q_earlier, -time_P},
                {speed_Q_earlier, -e * time_P}});

  const auto product = [&](const char* id, const ex& element, const ex& value, const char* words) {
    return kernel.definition(
        {.id = id, .statement = {element, value}, .words = words, .indices = from_one});
  };
  const char* const back = "the gap before that collision, followed back to time 0";
  const Theorem x_P_n = product("wedge.x_P_definition", x_P(n), r_P(n) * tau_P(n), back);
  const Theorem x_Q_n = product("wedge.x_Q_definition", x_Q(n), r_Q(n) * tau_Q(n), back);
  const char* const size = "approach speed times the distance of A and B";
  const Theorem D_P_n = product("wedge.D_P_definition", D_P(n), r_P(n) * d_P(n), size);
  const Theorem D_Q_n = product("wedge.D_Q_definition", D_Q(n), r_Q(n) * d_Q(n), size);
  const Theorem x_P_earlier = earlier("wedge.x_P", x_P_n),
                x_Q_earlier = earlier("wedge.x_Q", x_Q_n),
                D_Q_earlier = earlier("wedge.D_Q", D_Q_n),
                opening_Q_earlier = earlier("wedge.opening_Q", opening_Q);

  const char* const alike = "the gaps at time 0 obey the recurrence of the speeds";
  const Theorem x_P_next = combined(
      "wedge.x_P_next", {x_P(n), (1 + e) * mu_B * x_Q(n - 1) - e * x_P(n - 1)}, alike, from_two,
      {{x_P_n, 1},
       {x_Q_earlier, -(1 + e) * mu_B},
       {x_P_earlier, e},
       {speeds.next_P, tau_Q(n - 1)},
       {crossing_P, 1},
       {opening_Q_earlier, 1}});
  const Theorem x_Q_next = combined(
      "wedge.x_Q_next", {x_Q(n), (1 + e) * mu_A * x_P(n) - e * x_Q(n - 1)}, alike, from_two,
      {{x_Q_n, 1},
       {x_P_n, -(1 + e) * mu_A},
       {x_Q_earlier, e},
       {speeds.next_Q, tau_P(n)},
       {crossing_Q, 1},
       {opening_P, 1}});
  const Theorem x_Q_cycle =
      combined("wedge.x_Q_cycle", {x_Q(n), x_Q_next.rhs().subs(x_P(n) == x_P_next.rhs()).expand()},
               "from those a cycle earlier", from_two, {{x_Q_next, 1}, {x_P_next, (1 + e) * mu_A}});
  const Theorem D_half =
      combined("wedge.D_Q_next", {D_Q(n), e * D_P(n)}, "e of it is left", from_one,
               {{D_Q_n, 1}, {D_P_n, -e}, {opening_Q, r_Q(n)}, {crossing_Q, e * r_P(n)}});
  const Theorem D_half_earlier = earlier("wedge.D_Q_next", D_half);
  const Theorem D_cycle = combined("wedge.D_P_next", {D_P(n), pow(e, 2) * D_P(n - 1)},
                                   "e^2 of it is left each cycle", from_two,
                                   {{D_P_n, 1},
                                    {D_Q_earlier, -e},
                                    {opening_P, r_P(n)},
                                    {crossing_P, e * r_Q(n - 1)},
                                    {D_half_earlier, e}});

  const Theorem x_P_1 = at("wedge.x_P_1", x_P_n, 1, {}), x_Q_1 = at("wedge.x_Q_1", x_Q_n, 1, {}),
                D_P_1 = at("wedge.D_P_1", D_P_n, 1, {}),
                crossing_1 = at("wedge.crossing_1", crossing_Q, 1, {});
  const Theorem first_x_P = combined("wedge.first_x_P", {x_P(1), 0}, "the clock starts there", {},
                                     {{x_P_1, 1}, {t_1, r_P(1)}});
  const Theorem first_x_Q = combined("wedge.first_x_Q", {x_Q(1), L}, "the ball starts from A then",
                                     {}, {{x_Q_1, 1}, {crossing_1, 1}, {t_1, r_Q(1)}, {d_1, 1}});
  const Theorem first_D =
      combined("wedge.first_D_P", {D_P(1), L * speeds.first_P.rhs()}, "at the first collision", {},
               {{D_P_1, 1}, {d_1, r_P(1)}, {speeds.first_P, L}});
  return {x_P_n,    x_Q_n,     D_P_n,   D_Q_n,   first_x_P, first_x_Q,
          x_P_next, x_Q_cycle, first_D, D_cycle, D_half};
}

WedgeSolution wedge_solution(Kernel& kernel, const Regime& regime, const WedgeSpeeds& speeds,
                             const WedgeMotion& motion) {
  const ex n = symbol("n"), e = symbol("e"), V = symbol("V"), L = symbol("L");
  const auto here = [&](const ex& expression) { return expression.subs(regime.parameters); };
  const ex g = here(regime.g);
  const auto named = [&](const std::string& name) { return regime.id + name; };
  // A premise at this regime's parameters.
  const auto premise = [&](const char* name, const Theorem& theorem, const Indices& indices) {
    if (regime.parameters.empty()) return theorem;
    Kernel::Values values;
    for (const auto& [parameter, value] : regime.parameters) values.emplace_back(parameter, value);
    return kernel.instance({.id = named(name),
                            .statement = {here(theorem.lhs()), here(theorem.rhs())},
                            .words = "at these parameters",
                            .indices = indices,
                            .assuming = regime.assuming},
                           theorem, values);
  };
  struct Pair {
    Theorem first, second;
  };
  const auto solved = [&](const std::string& name, const std::vector<ex>& elements,
                          const std::vector<ex>& forms, const std::vector<Theorem>& initial,
                          const std::vector<Theorem>& next, const char* words) {
    const Theorem both =
        kernel.induction({.id = named(name),
                          .statement = {matrix{{here(elements[0])}, {here(elements[1])}},
                                        matrix{{forms[0]}, {forms[1]}}},
                          .words = "by induction over the cycles",
                          .indices = from_one,
                          .assuming = regime.assuming},
                         initial, next, n);
    const auto one = [&](const char* suffix, unsigned row) {
      return kernel.component({.id = named(name + suffix),
                               .statement = {here(elements[row]), forms[row]},
                               .words = words,
                               .indices = from_one,
                               .assuming = regime.assuming},
                              both, row);
    };
    const Theorem first = one("_P", 0);
    return Pair{first, one("_Q", 1)};
  };
  const auto& sigma = regime.sigma;
  const ex growth = pow(e, n - 1), ratio = sqrt(e) / g;
  const Theorem first_P = premise("first_P", speeds.first_P, {}),
                first_Q = premise("first_Q", speeds.first_Q, {}),
                next_P = premise("next_P", speeds.next_P, from_two),
                cycle_Q = premise("cycle_Q", speeds.cycle_Q, from_two);
  const Pair r = solved("r", {r_P(n), r_Q(n)},
                        {V * growth * sigma(2 * n - 1), V * growth * ratio * sigma(2 * n)},
                        {first_P, first_Q}, {next_P, cycle_Q}, "the approach speeds");
  const Theorem first_x_P = premise("first_x_P", motion.first_x_P, {}),
                first_x_Q = premise("first_x_Q", motion.first_x_Q, {}),
                x_P_next = premise("x_P_next", motion.x_P_next, from_two),
                x_Q_cycle = premise("x_Q_cycle", motion.x_Q_cycle, from_two);
  const Pair x = solved("x", {x_P(n), x_Q(n)},
                        {L * growth / ratio * sigma(2 * n - 2), L * growth * sigma(2 * n - 1)},
                        {first_x_P, first_x_Q}, {x_P_next, x_Q_cycle}, "the gaps at time 0");
  const Theorem first_D = premise("first_D", motion.first_D, {}),
                D_cycle = premise("D_cycle", motion.D_cycle, from_two),
                D_half = premise("D_half", motion.D_half, from_one);
  const Theorem D_P_n = kernel.induction({.id = named("D_P"),
                                          .statement = {here(D_P(n)), L * V * pow(e, 2 * n - 2)},
                                          .words = "by induction over the cycles",
                                          .indices = from_one,
                                          .assuming = regime.assuming},
                                         {first_D}, {D_cycle}, n);
  const Theorem D_Q_n = kernel.rewriting({.id = named("D_Q"),
                                          .statement = {here(D_Q(n)), L * V * pow(e, 2 * n - 1)},
                                          .words = "e of it is left",
                                          .indices = from_one,
                                          .assuming = regime.assuming},
                                         {D_half, D_P_n});
  // Both sides over the approach speed.
  const auto quotient = [&](const char* name, const ex& element, const ex& form,
                            const Theorem& definition, const Theorem& value, const Theorem& speed,
                            const char* words) {
    const ex one_over = 1 / speed.rhs();
    return kernel.consequence(
        {.id = named(name),
         .statement = {here(element), form},
         .words = words,
         .indices = from_one,
         .assuming = regime.assuming},
        {{definition, -one_over}, {value, one_over}, {speed, -here(element) * one_over}});
  };
  const Theorem of_x_P = premise("x_P_definition", motion.x_P, from_one),
                of_x_Q = premise("x_Q_definition", motion.x_Q, from_one),
                of_D_P = premise("D_P_definition", motion.D_P, from_one),
                of_D_Q = premise("D_Q_definition", motion.D_Q, from_one);
  const ex unit = L / (V * ratio);
  const Theorem tau_P_n = quotient("tau_P", tau_P(n), unit * sigma(2 * n - 2) / sigma(2 * n - 1),
                                   of_x_P, x.first, r.first, "the time of P_n");
  const Theorem tau_Q_n = quotient("tau_Q", tau_Q(n), unit * sigma(2 * n - 1) / sigma(2 * n),
                                   of_x_Q, x.second, r.second, "the time of Q_n");
  const Theorem d_P_n = quotient("d_P", d_P(n), L * growth / sigma(2 * n - 1), of_D_P, D_P_n,
                                 r.first, "the distance from A to B then");
  const Theorem d_Q_n = quotient("d_Q", d_Q(n), L * growth * e / (ratio * sigma(2 * n)), of_D_Q,
                                 D_Q_n, r.second, "the distance from A to B then");
  return {r.first, r.second, tau_P_n, tau_Q_n, d_P_n, d_Q_n};
}

}  // namespace magicmass::derivation
