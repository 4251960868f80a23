// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 8: after the last collision.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

// What N = ceil(pi/psi - s) says of the angles before and after the last collision of one block.
struct LastCollision {
  Theorem reached, not_before;  // pi <= (N + s) psi, pi > (N + s - 1) psi
  Theorem within;               // 2 pi > (N + s) psi
  Theorem sine_before, sine_after;
};
LastCollision last_collision(Kernel& kernel, const Theorem& count, const ex& s,
                             const Theorem& psi_below_pi, const Paper& paper,
                             const std::string& label) {
  const ex psi = symbol("psi");
  const std::string id = "terminal." + count.step().from;
  const ex after = (count.lhs() + s) * psi, before = (count.lhs() + s - 1) * psi;
  const Theorem reached =
      kernel.ceiling_bound({.id = id + "_reached",
                            .statement = {Pi, Relation::less_equal, after},
                            .words = "the ceiling from below: the angle has reached pi",
                            .indices = last_collisions},
                           count);
  const Theorem not_before =
      kernel.ceiling_bound({.id = id + "_not_before",
                            .statement = {Pi, Relation::greater, before},
                            .words = "the ceiling from above: one cycle earlier it had not",
                            .indices = last_collisions},
                           count);
  const Theorem within = kernel.ordering({.id = id + "_within",
                                          .statement = {2 * Pi, Relation::greater, after},
                                          .words = "and psi < pi more is less than 2 pi",
                                          .indices = last_collisions},
                                         {{1, {not_before}, 1}, {1, {psi_below_pi}, 1}});
  const Theorem sine_before = kernel.sine_sign({.id = id + "_sine_before",
                                                .statement = paper.at(label + ", before"),
                                                .words = "so the last collision takes place",
                                                .label = label,
                                                .indices = last_collisions},
                                               {not_before});
  const Theorem sine_after = kernel.sine_sign({.id = id + "_sine_after",
                                               .statement = paper.at(label + ", after"),
                                               .words = "and no other comes after it",
                                               .label = label,
                                               .indices = last_collisions},
                                              {reached, within});
  return {reached, not_before, within, sine_before, sine_after};
}

}  // namespace

Terminal terminal(Kernel& kernel, const Power& power, const Counting& counting,
                  const Ratios& ratios, const Paper& paper) {
  const ex psi = symbol("psi"), alpha = symbol("alpha"), V = symbol("V"), n = symbol("n");
  const ex N_A = symbol("N_A"), N_B = symbol("N_B"), V_CM = symbol("V_CM");
  const Theorem psi_below_pi = kernel.angle_below_pi({.id = "terminal.psi_below_pi",
                                                      .statement = {Pi, Relation::greater, psi},
                                                      .words = "twice an arctangent"});
  const LastCollision of_A = last_collision(kernel, counting.N_A, one_half, psi_below_pi, paper,
                                            "eq:NA-constraint-simple");
  const LastCollision of_B =
      last_collision(kernel, counting.N_B, 1, psi_below_pi, paper, "eq:NB-constraint-simple");

  // The approach speeds are positive multiples of those sines.
  const std::vector<Theorem> velocities{power.a, power.b, power.c, power.c_prime};
  const ex size_A = counting.before_P.rhs() / sin((n + one_half) * psi);
  const ex size_B = counting.before_Q.rhs() / sin((n + 1) * psi);
  kernel.ordering({.id = "terminal.A_stays_behind",
                   .statement = paper.at("eq:NA-constraint"),
                   .words = "after its last collision A does not catch up with C",
                   .label = "eq:NA-constraint",
                   .indices = last_collisions},
                  {{size_A, {of_A.sine_after}, 1}}, velocities);
  kernel.ordering({.id = "terminal.C_stays_behind",
                   .statement = paper.at("eq:NB-constraint"),
                   .words = "after B's last collision C does not catch up with it",
                   .label = "eq:NB-constraint",
                   .indices = last_collisions},
                  {{size_B, {of_B.sine_after}, 1}}, velocities);

  // The last collision of all is a Q (N_A = N_B) or a P (N_A = N_B + 1).
  struct Case {
    std::string name;
    Theorem counts;
    ex c_t;
    std::string label;
  };
  for (const Case& at_last :
       {Case{"after_Q", counting.equal, c_prime(N_B), "eq:ct, after Q"},
        Case{"after_P", counting.one_more_above_half, c(N_A), "eq:ct, after P"},
        Case{"after_P_whole", counting.one_more_at_zero, c(N_A), "eq:ct, after P"}}) {
    const std::string id = "terminal." + at_last.name;
    std::vector<Theorem> equations{at_last.counts};
    equations.insert(equations.end(), velocities.begin(), velocities.end());
    kernel.rewriting({.id = id + "_c_t",
                      .statement = paper.at(at_last.label),
                      .words = "the ball's terminal velocity, as momentum demands",
                      .label = "eq:ct",
                      .indices = last_collisions},
                     equations);
    const bool is_Q = at_last.name == "after_Q";
    kernel.ordering({.id = id + "_a_below_c",
                     .statement = {a(N_A), Relation::less_equal, at_last.c_t},
                     .words = is_Q ? "A does not catch up" : "A has just been hit by C",
                     .label = "sec:result, a_t <= c_t <= b_t",
                     .indices = last_collisions},
                    {{size_A, {is_Q ? of_A.sine_after : of_A.sine_before}, 1}}, equations);
    kernel.ordering({.id = id + "_c_below_b",
                     .statement = {at_last.c_t, Relation::less_equal, b(N_B)},
                     .words = is_Q ? "C has just hit B" : "C does not catch up",
                     .label = "sec:result, a_t <= c_t <= b_t",
                     .indices = last_collisions},
                    {{size_B, {is_Q ? of_B.sine_before : of_B.sine_after}, 1}}, equations);
  }

  const Theorem b_below_V =
      kernel.ordering({.id = "terminal.b_below_V",
                       .statement = paper.at("sec:result, b_t <= V"),
                       .words = "V - b_t is a square times something positive",
                       .label = "sec:result, b_t <= V",
                       .indices = last_collisions},
                      {{2 * V_CM * (1 + alpha), {}, cos((N_B + one_half) * psi / 2)}}, {power.b});

  // a_t as a product: one factor is positive, the other is not, and it vanishes at the thresholds of A only.
  const ex after = (N_A + one_half) * psi / 2, before = (N_A - one_half) * psi / 2;
  const auto halved = [&](const std::string& id, const Statement& statement, const Theorem& whole) {
    return kernel.ordering(
        {.id = id, .statement = statement, .words = "divided by two", .indices = last_collisions},
        {{one_half, {whole}, 1}});
  };
  const Theorem half_before =
      halved("terminal.half_before", {Pi / 2, Relation::greater, before}, of_A.not_before);
  const Theorem half_reached =
      halved("terminal.half_reached", {Pi / 2, Relation::less_equal, after}, of_A.reached);
  const Theorem half_within =
      halved("terminal.half_within", {Pi, Relation::greater, after}, of_A.within);
  const auto cosine = [&](const std::string& id, const Statement& statement,
                          const std::vector<Theorem>& bounds) {
    return kernel.sine_sign({.id = id,
                             .statement = statement,
                             .words = "a cosine on that side of pi/2",
                             .indices = last_collisions},
                            bounds);
  };
  const Theorem cosine_before =
      cosine("terminal.cosine_before", {cos(before), Relation::greater, 0}, {half_before});
  const Theorem cosine_after = cosine(
      "terminal.cosine_after", {cos(after), Relation::less_equal, 0}, {half_reached, half_within});
  const ex front = 2 * V_CM * (1 + alpha);
  kernel.ordering({.id = "terminal.a_recoils_or_stops",
                   .statement = {a(N_A), Relation::less_equal, 0},
                   .words = "A never goes on forward",
                   .label = "sec:result, a_t < 0",
                   .indices = last_collisions},
                  {{front, {cosine_before, cosine_after}, 1}}, {power.a});
  const Theorem not_magic =
      kernel.hypothesis({.id = "terminal.not_magic",
                         .statement = {Pi, Relation::not_equal, (N_A + one_half) * psi},
                         .words = "away from the magic ratios, where psi = pi/(k + 1/2), k = N_A",
                         .indices = last_collisions});
  const Theorem beyond =
      kernel.strictly({.id = "terminal.beyond",
                       .statement = {(N_A + one_half) * psi, Relation::greater, Pi},
                       .words = "the angle is beyond pi",
                       .indices = last_collisions},
                      of_A.reached, not_magic);
  const Theorem half_beyond =
      halved("terminal.half_beyond", {after, Relation::greater, Pi / 2}, beyond);
  const Theorem cosine_beyond = cosine("terminal.cosine_beyond", {0, Relation::greater, cos(after)},
                                       {half_beyond, half_within});
  kernel.ordering({.id = "terminal.a_recoils",
                   .statement = paper.at("sec:result, a_t < 0"),
                   .words = "so A recoils at every other mass ratio",
                   .label = "sec:result, a_t < 0",
                   .indices = last_collisions},
                  {{front, {cosine_before, cosine_beyond}, 1}}, {power.a});

  // At the thresholds.
  const Indices at_k{{"k", 1}, {"N_A", 1}, {"N_B", 1}};
  const auto value_at = [&](const std::string& id, const std::string& label, const RatioCase& at,
                            const char* words) {
    std::vector<Theorem> equations{at.N_A, at.N_B};
    equations.insert(equations.end(), velocities.begin(), velocities.end());
    equations.insert(equations.end(), {power.V_CM, at.angle, at.ratio});
    return kernel.rewriting({.id = "terminal." + id,
                             .statement = paper.at("sec:result, " + label),
                             .words = words,
                             .label = "sec:result, " + label,
                             .indices = at_k},
                            equations);
  };
  value_at("magic_a", "a_t at alpha_k", ratios.magic, "at alpha_k A stops");
  value_at("magic_c", "c_t at alpha_k", ratios.magic, "at alpha_k C stops");
  value_at("magic_b", "b_t at alpha_k", ratios.magic, "at alpha_k B carries all");
  value_at("deficient_a", "a_t at beta_k", ratios.deficient, "at beta_k A recoils");
  const Theorem b_at_beta =
      value_at("deficient_b", "b_t at beta_k", ratios.deficient, "at beta_k B keeps this");
  value_at("deficient_c", "c_t at beta_k", ratios.deficient, "and C goes with it");
  return {psi_below_pi,    of_B.reached, of_B.not_before, of_A.reached,
          of_A.not_before, b_below_V,    b_at_beta};
}

}  // namespace magicmass::derivation
