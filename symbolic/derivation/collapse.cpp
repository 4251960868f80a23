// SPDX-License-Identifier: GPL-2.0-or-later
// Where 4 e <= (1 + e)^2 mu_A mu_B the collisions never end: inelastic collapse, in a finite time.
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
using GiNaC::numeric;

namespace {

Theorem at_parameters(Kernel& kernel, const std::string& id, const Theorem& general,
                      const Kernel::Values& values, const Indices& indices,
                      const std::vector<Statement>& assuming) {
  GiNaC::exmap replacements;
  for (const auto& [name, value] : values) replacements[name] = value;
  return kernel.instance(
      {.id = id,
       .statement = {general.lhs().subs(replacements), general.rhs().subs(replacements)},
       .words = "at these parameters",
       .indices = indices,
       .assuming = assuming},
      general, values);
}

// r_P(n) > 0 and r_Q(n) > 0 for all n: in units of e^(n - 1) and of the ratio of the two, the speeds grow
// from each collision to the next.
void never_ending(Kernel& kernel, const Wedge& wedge) {
  const ex n = symbol("n"), e = symbol("e"), C = symbol("C");
  const ex mu_A = symbol("mu_A"), mu_B = symbol("mu_B");
  const std::vector<Statement> assuming{{1, Relation::less_equal, C}};
  const Kernel::Values values{{mu_B, 4 * e * pow(C, 2) / (pow(1 + e, 2) * mu_A)}};
  const auto here = [&](const char* name, const Theorem& general, const Indices& indices) {
    return at_parameters(kernel, std::string("collapse.") + name, general, values, indices,
                         assuming);
  };
  const Theorem first_P = here("first_P", wedge.speeds.first_P, {}),
                first_Q = here("first_Q", wedge.speeds.first_Q, {}),
                next_P = here("next_P", wedge.speeds.next_P, from_two),
                cycle_Q = here("cycle_Q", wedge.speeds.cycle_Q, from_two);
  const ex ratio = 2 * C / ((1 + e) * mu_A);  // g/sqrt(e)
  const ex speed_P = next_P.lhs(), speed_Q = cycle_Q.lhs();
  const std::vector<ex> growing{speed_P, ratio * speed_Q - speed_P};
  // With P, Q the two before: next P = 2 C Q - P and then next Q = 2 C P - Q, each time times e.
  const ex d = 2 * C - 1;
  const matrix factors{{e * d, 2 * C * e}, {e * (pow(d, 2) - 1), e * (2 * C * d - 1)}};
  const auto positive = [&](const char* id, const ex& value, const char* words) {
    return kernel.positivity_by_induction({.id = id,
                                           .statement = {value, Relation::greater, 0},
                                           .words = words,
                                           .indices = from_one,
                                           .assuming = assuming},
                                          growing, factors, {first_P, first_Q}, {next_P, cycle_Q},
                                          n);
  };
  const Theorem always_P =
      positive("collapse.always_P_C", growing[0], "A always catches up with the ball again");
  positive("collapse.growth_C", growing[1], "each speed exceeds the one before, rescaled");
  const std::vector<ex> also_Q{growing[0], growing[1], speed_Q};
  const matrix with_Q{
      {factors(0, 0), factors(0, 1), 0},
      {factors(1, 0), factors(1, 1), 0},
      {(factors(0, 0) + factors(1, 0)) / ratio, (factors(0, 1) + factors(1, 1)) / ratio, 0}};
  const Theorem always_Q =
      kernel.positivity_by_induction({.id = "collapse.always_Q_C",
                                      .statement = {also_Q[2], Relation::greater, 0},
                                      .words = "and the ball with B",
                                      .indices = from_one,
                                      .assuming = assuming},
                                     also_Q, with_Q, {first_P, first_Q}, {next_P, cycle_Q}, n);

  // For any shares with C = (1 + e)/(2 sqrt(e)) sqrt(mu_A mu_B) >= 1.
  const ex cosine = (1 + e) / (2 * sqrt(e)) * sqrt(mu_A * mu_B);
  const std::vector<Statement> reached{{1, Relation::less_equal, cosine}};
  const auto for_shares = [&](const char* id, const ex& value, const Theorem& general,
                              const char* words) {
    kernel.instance({.id = id,
                     .statement = {value, Relation::greater, 0},
                     .words = words,
                     .indices = from_one,
                     .assuming = reached},
                    general, {{C, cosine}});
  };
  for_shares("collapse.always_P", r_P(n), always_P, "there is no last collision with A");
  for_shares("collapse.always_Q", r_Q(n), always_Q, "and none with B");
}

Theorem threshold(Kernel& kernel) {
  const ex e = symbol("e"), alpha = symbol("alpha"), mu_A = symbol("mu_A"), mu_B = symbol("mu_B");
  const ex front = (1 + e) / (2 * sqrt(e));
  const std::vector<Statement> below_one{{1, Relation::greater, e}};
  kernel.positivity(
      {.id = "collapse.one_sided",
       .statement = {-front.diff(GiNaC::ex_to<GiNaC::symbol>(e)), Relation::greater, 0},
       .words = "C falls as e grows to 1, so collapse is for small e",
       .assuming = below_one});
  // C = 1 where e + 1/e = 4/(mu_A mu_B) - 2.
  const ex share = mu_A * mu_B, root = sqrt(1 - share), at = symbol("e_c");
  const std::vector<Statement> lighter{{1, Relation::greater, share}};
  const Theorem critical = kernel.definition({.id = "collapse.e_c",
                                              .statement = {at, share / pow(1 + root, 2)},
                                              .words = "the largest e with a collapse",
                                              .assuming = lighter});
  kernel.identity(
      {.id = "collapse.sign",
       .statement = {pow(front, 2) * share - 1, share * (at - e) * (1 / at - e) / (4 * e)},
       .words = "C^2 - 1 has the sign of e_c - e, as e <= 1 < 1/e_c",
       .assuming = lighter});
  const Theorem apart = kernel.identity({.id = "collapse.e_c_apart",
                                         .statement = {1 / at - at, 4 * root / share},
                                         .words = "how far e_c is from its inverse",
                                         .assuming = lighter});
  kernel.positivity({.id = "collapse.e_c_below_one",
                     .statement = {apart.rhs(), Relation::greater, 0},
                     .words = "so e_c < 1 < 1/e_c",
                     .assuming = lighter});
  const auto value = [&](const char* id, const ex& at_A, const ex& at_B, const ex& e_there,
                         const char* words) {
    kernel.identity(
        {.id = id,
         .statement = {critical.rhs().subs(GiNaC::lst{mu_A == at_A, mu_B == at_B}), e_there},
         .words = words});
  };
  value("collapse.equal_masses", one_half, one_half, 7 - 4 * sqrt(ex(3)), "three equal masses");
  value("collapse.wall_equal_masses", one_half, 1, 3 - 2 * sqrt(ex(2)),
        "a ball as heavy as the block, and a wall");
  const ex heaviest = symbol("alpha_c");
  const Theorem alpha_c =
      kernel.definition({.id = "collapse.alpha_c",
                         .statement = {heaviest, front - 1},
                         .words = "equal blocks: the heaviest ball with a collapse"});
  kernel.identity({.id = "collapse.alpha_c_sign",
                   .statement = {front / (1 + alpha) - 1, (heaviest - alpha) / (1 + alpha)},
                   .words = "C - 1 has the sign of alpha_c - alpha"});
  return alpha_c;
}

// All four velocities after n collisions, from a regime's approach speeds.
void velocities(Kernel& kernel, const Wedge& wedge, const Regime& regime,
                const WedgeSolution& solution) {
  const ex n = symbol("n");
  Kernel::Values values;
  for (const auto& [name, value] : regime.parameters) values.emplace_back(name, value);
  const std::vector<ex> next{solution.r_P.lhs().subs(n == n + 1),
                             solution.r_P.rhs().subs(n == n + 1)};
  const GiNaC::exmap speeds{{next[0], next[1]},
                            {solution.r_P.lhs(), solution.r_P.rhs()},
                            {solution.r_Q.lhs(), solution.r_Q.rhs()}};
  const auto closed = [&](const std::string& name, const Theorem& general,
                          const std::vector<Theorem>& before) {
    const Theorem here = at_parameters(kernel, regime.id + name + "_from_speeds", general, values,
                                       from_one, regime.assuming);
    std::vector<Theorem> equations{here};
    equations.insert(equations.end(), before.begin(), before.end());
    equations.insert(equations.end(), {solution.r_P, solution.r_Q});
    ex form = here.rhs();
    for (const Theorem& known : before) form = form.subs(known.lhs() == known.rhs());
    return kernel.rewriting({.id = regime.id + name,
                             .statement = {here.lhs(), form.subs(speeds)},
                             .words = "in closed form",
                             .indices = from_one,
                             .assuming = regime.assuming},
                            equations);
  };
  const Theorem of_A = closed("v_A", wedge.velocities.v_A_from_speeds, {});
  closed("v_B", wedge.velocities.v_B_from_speeds, {});
  closed("v_C", wedge.velocities.v_C_from_A, {of_A});
  closed("v_C_prime", wedge.velocities.v_C_prime_from_speeds, {});
}

// C > 1: sinh takes the place of sin. With xi = exp(eta), C = (xi + 1/xi)/2.
std::pair<Theorem, ex> finite_time(Kernel& kernel, const Wedge& wedge) {
  const ex n = symbol("n"), e = symbol("e"), V = symbol("V"), L = symbol("L"), p = symbol("p");
  const ex mu_A = symbol("mu_A"), mu_B = symbol("mu_B"), xi = symbol("xi");
  const ex twice_C = xi + 1 / xi;
  const std::vector<Statement> assuming{{xi, Relation::greater, 1}};
  const Regime regime{
      .id = "collapse.beyond_",
      .parameters = {{mu_B, e * pow(twice_C, 2) / (pow(1 + e, 2) * mu_A)}},
      .g = sqrt(e) * twice_C / ((1 + e) * mu_A),
      .sigma = [xi](const ex& k) { return (pow(xi, k) - pow(xi, -k)) / (xi - 1 / xi); },
      .assuming = assuming};
  const WedgeSolution solution = wedge_solution(kernel, regime, wedge.speeds, wedge.motion);
  velocities(kernel, wedge, regime, solution);
  const ex unit = L / V * regime.g / sqrt(e), end = unit / xi;
  const ex small = pow(xi, -4 * n);
  const auto limit = [&](const char* id, const Theorem& closed, const ex& form) {
    return kernel.limit({.id = id,
                         .statement = {limit_at_infinity(closed.lhs(), n), end},
                         .words = "infinitely many collisions in a finite time",
                         .indices = from_one,
                         .assuming = assuming},
                        closed, form, p, small);
  };
  const Theorem t_infinity = limit("collapse.t_P_infinity", solution.tau_P,
                                   unit * (1 / xi - pow(xi, 3) * p) / (1 - pow(xi, 2) * p));
  limit("collapse.t_Q_infinity", solution.tau_Q, unit * (1 / xi - xi * p) / (1 - p));
  const auto left = [&](const std::string& id, const Theorem& closed, const ex& form) {
    const Theorem remaining = kernel.rewriting({.id = id,
                                                .statement = {end - closed.lhs(), form},
                                                .words = "what is left of the time",
                                                .indices = from_one,
                                                .assuming = assuming},
                                               {closed});
    kernel.positivity({.id = id + "_positive",
                       .statement = {remaining.rhs(), Relation::greater, 0},
                       .words = "no collision is later",
                       .indices = from_one,
                       .assuming = assuming});
  };
  left("collapse.left_P", solution.tau_P,
       unit * xi * (pow(xi, 2) - 1) / (pow(xi, 4 * n) - pow(xi, 2)));
  left("collapse.left_Q", solution.tau_Q, unit * (xi - 1 / xi) / (pow(xi, 4 * n) - 1));
  // xi from the shares.
  const ex C = (1 + e) / (2 * sqrt(e)) * sqrt(mu_A * mu_B);
  const std::vector<Statement> beyond{{pow(1 + e, 2) * mu_A * mu_B, Relation::greater, 4 * e}};
  const Theorem base = kernel.definition({.id = "collapse.exp_eta",
                                          .statement = {symbol("exp_eta"), C + sqrt(pow(C, 2) - 1)},
                                          .words = "exp(eta), where cosh(eta) = C",
                                          .assuming = beyond});
  kernel.identity({.id = "collapse.cosh_eta",
                   .statement = {(base.lhs() + 1 / base.lhs()) / 2, C},
                   .words = "cosh(eta) = C",
                   .assuming = beyond});
  kernel.identity({.id = "collapse.share_of_B",
                   .statement = {regime.parameters.begin()->second.subs(xi == base.lhs()), mu_B},
                   .words = "so every pair of shares with C > 1 has its xi",
                   .assuming = beyond});
  return {t_infinity, regime.parameters.begin()->second};
}

// C = 1, between the two: the speeds grow linearly.
void at_threshold(Kernel& kernel, const Wedge& wedge) {
  const ex n = symbol("n"), e = symbol("e"), V = symbol("V"), L = symbol("L"), p = symbol("p");
  const ex mu_A = symbol("mu_A"), mu_B = symbol("mu_B");
  const Regime regime{.id = "collapse.threshold_",
                      .parameters = {{mu_B, 4 * e / (pow(1 + e, 2) * mu_A)}},
                      .g = 2 * sqrt(e) / ((1 + e) * mu_A),
                      .sigma = [](const ex& k) { return k; },
                      .assuming = {}};
  const WedgeSolution solution = wedge_solution(kernel, regime, wedge.speeds, wedge.motion);
  velocities(kernel, wedge, regime, solution);
  const ex unit = L / V * regime.g / sqrt(e);
  kernel.limit({.id = "collapse.threshold_t_infinity",
                .statement = {limit_at_infinity(solution.tau_P.lhs(), n), unit},
                .words = "the time in which they all happen",
                .indices = from_one},
               solution.tau_P, unit * (2 - 2 * p) / (2 - p), p, 1 / n);
}

}  // namespace

Collapse collapse(Kernel& kernel, const Wedge& wedge) {
  never_ending(kernel, wedge);
  const Theorem alpha_c = threshold(kernel);
  at_threshold(kernel, wedge);
  const auto [t_infinity, share_of_B] = finite_time(kernel, wedge);
  return {alpha_c, t_infinity, share_of_B};
}

}  // namespace magicmass::derivation
