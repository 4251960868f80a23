// SPDX-License-Identifier: GPL-2.0-or-later
// Chapter 7: the thresholds, and why they are the magic and the deficient mass ratios.
#include <ginac/ginac.h>

#include "derivation/chapters.hpp"
#include "derivation/matrices.hpp"
#include "derivation/shorthand.hpp"
#include "proof/names.hpp"

namespace magicmass::derivation {

using namespace proof;
using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::Pi;

namespace {

const Indices last_from_one{{"N_B", 1}};

struct Threshold {
  Theorem angle;  // psi = pi/(k + s), the case under study
  Theorem ratio;  // alpha at it
  Theorem named;  // alpha_k or beta_k = that
  Theorem stable;
};

// Where pi/psi - s = k: solved for alpha, and back.
Threshold threshold(Kernel& kernel, const Rotation& rotation, const Theorem& count,
                    const Theorem& increases, const ex& shift, const std::string& name,
                    const std::string& label, const std::string& range_label,
                    const std::string& critical_label, const Paper& paper) {
  const ex k = symbol("k"), alpha = symbol("alpha"), psi = symbol("psi");
  const std::string id = "ratios." + name;
  const Theorem angle = kernel.hypothesis(
      {.id = id + "_angle",
       .statement = {psi, Pi / (k + shift)},
       .words = "the case at which " + count.step().from + " is about to become k + 1",
       .indices = k_from_one});
  const ex x = (Pi / (2 * (k + shift))).normal();
  const Theorem cosine = kernel.rewriting({.id = id + "_cosine",
                                           .statement = {cos(psi / 2), cos(x)},
                                           .words = "half the angle",
                                           .indices = k_from_one},
                                          {angle});
  const Theorem ratio = kernel.consequence(
      {.id = id + "_ratio",
       .statement = {alpha, 1 / cos(x) - 1},
       .words = "cos(psi/2) = 1/(1 + alpha), solved for alpha",
       .indices = k_from_one},
      {{rotation.cos_half_psi, (1 + alpha) / cos(x)}, {cosine, -(1 + alpha) / cos(x)}});
  const Theorem named = kernel.definition({.id = id,
                                           .statement = {symbol(name), ratio.rhs()},
                                           .words = "that mass ratio, by name",
                                           .indices = k_from_one});
  kernel.identity({.id = id + "_paper",
                   .statement = paper.at(label),
                   .words = "as the paper writes it",
                   .label = label,
                   .indices = k_from_one});
  const Theorem back = kernel.equal_angles(
      {.id = id + "_back",
       .statement = {rotation.psi.rhs().subs(alpha == named.rhs()), angle.rhs()},
       .words = "and psi there is that angle again",
       .indices = k_from_one});
  kernel.threshold({.id = id + "_range",
                    .statement = {symbol(name), named.rhs()},
                    .words = "the least alpha with " + count.step().from + " = k",
                    .label = range_label,
                    .indices = k_from_one},
                   count, increases, back, k);
  kernel.rewriting({.id = id + "_critical",
                    .statement = paper.at(critical_label),
                    .words = "at the threshold itself",
                    .label = critical_label,
                    .indices = k_from_one},
                   {angle});
  const Theorem stable =
      kernel.identity({.id = id + "_stable",
                       .statement = {symbol(name), 2 * pow(sin(x / 2), 2) / cos(x)},
                       .words = "without the difference of nearly equal numbers",
                       .indices = k_from_one});
  const ex square = pow(sin(x / 2), 2);
  kernel.identity({.id = id + "_from_sine",
                   .statement = {symbol(name), 2 * square / (1 - 2 * square)},
                   .words = "from one sine",
                   .indices = k_from_one});
  return {angle, ratio, named, stable};
}

// Momentum and energy of all three after the last collision, whether that was a P or a Q.
struct Totals {
  Theorem momentum, energy;
};
Totals totals(Kernel& kernel, const Power& power) {
  const ex n = symbol("n"), alpha = symbol("alpha"), V = symbol("V");
  const ex a_t = symbol("a_t"), b_t = symbol("b_t"), c_t = symbol("c_t");
  const std::vector<Theorem> velocities{power.a, power.b, power.c, power.c_prime};
  const Kernel::Values after_Q{{a_t, a(n)}, {b_t, b(n)}, {c_t, c_prime(n)}};
  const Kernel::Values after_P{{a_t, a(n)}, {b_t, b(n - 1)}, {c_t, c(n)}};
  const auto total = [&](const std::string& id, int degree, const char* words) {
    const auto sum = [&](const Kernel::Values& values) {
      return pow(values[0].second, degree) + pow(values[1].second, degree) +
             alpha * pow(values[2].second, degree);
    };
    const Theorem at_Q = kernel.rewriting({.id = id + "_Q",
                                           .statement = {sum(after_Q), pow(V, degree)},
                                           .words = std::string(words) + " after Q_n",
                                           .indices = from_one},
                                          velocities);
    const Theorem at_P = kernel.rewriting({.id = id + "_P",
                                           .statement = {sum(after_P), pow(V, degree)},
                                           .words = std::string(words) + " after P_n",
                                           .indices = from_one},
                                          velocities);
    return kernel.cases(
        {.id = id,
         .statement = {pow(a_t, degree) + pow(b_t, degree) + alpha * pow(c_t, degree),
                       pow(V, degree)},
         .words = "the last collision is a P or a Q",
         .indices = from_one},
        {{after_Q, at_Q}, {after_P, at_P}});
  };
  return {total("ratios.momentum", 1, "all momentum"), total("ratios.energy", 2, "all energy")};
}

}  // namespace

Ratios ratios(Kernel& kernel, const Rotation& rotation, const Power& power,
              const Counting& counting, const Paper& paper) {
  const ex n = symbol("n"), k = symbol("k"), alpha = symbol("alpha"), psi = symbol("psi"),
           V = symbol("V");
  const ex N_A = symbol("N_A"), N_B = symbol("N_B"), a_t = symbol("a_t"), b_t = symbol("b_t"),
           c_t = symbol("c_t");
  const Threshold magic =
      threshold(kernel, rotation, counting.N_A, counting.psi_increases, one_half, "alpha_k",
                "exact:ak", "NA-range", "eq:Naatcritical", paper);
  const Threshold deficient = threshold(kernel, rotation, counting.N_B, counting.psi_increases, 1,
                                        "beta_k", "exact:bk", "NB-range", "eq:Nbatcritical", paper);

  const auto count_at = [&](const std::string& id, const Theorem& count, const Threshold& at,
                            const ex& number, const std::string& label) {
    return kernel.step_functions({.id = id,
                                  .statement = {count.lhs(), number},
                                  .words = "the count there",
                                  .label = label,
                                  .indices = k_from_one},
                                 {count, at.angle}, k);
  };
  const Theorem magic_N_A = count_at("ratios.magic_N_A", counting.N_A, magic, k, "eq:Naatcritical");
  const Theorem magic_N_B = count_at("ratios.magic_N_B", counting.N_B, magic, k, "eq:Naatcritical");
  const Theorem deficient_N_A =
      count_at("ratios.deficient_N_A", counting.N_A, deficient, k + 1, "eq:Nbatcritical");
  const Theorem deficient_N_B =
      count_at("ratios.deficient_N_B", counting.N_B, deficient, k, "eq:Nbatcritical");

  // At alpha_k everything goes to B; at beta_k, B and C end up together.
  const auto velocity_at = [&](const std::string& id, const Statement& statement,
                               const Threshold& at, const char* words) {
    return kernel.rewriting(
        {.id = id, .statement = statement, .words = words, .indices = k_from_one},
        {power.a, power.b, power.c, power.c_prime, power.V_CM, at.angle, at.ratio});
  };
  velocity_at("ratios.magic_a", {a(k), 0}, magic, "A stops");
  velocity_at("ratios.magic_c_prime", {c_prime(k), 0}, magic, "C stops");
  const Theorem magic_b = velocity_at("ratios.magic_b", {b(k), V}, magic, "B carries all");
  velocity_at("ratios.deficient_b", {b(k), 2 * V / (2 + alpha)}, deficient, "B");
  velocity_at("ratios.deficient_c", {c(k + 1), 2 * V / (2 + alpha)}, deficient, "C goes with B");
  velocity_at("ratios.deficient_a", {a(k + 1), -alpha * V / (2 + alpha)}, deficient, "A recoils");

  // Terminal velocities are the closed forms at the last n.
  const auto terminal = [&](const std::string& id, const Theorem& velocity, const ex& last,
                            const std::string& label) {
    return kernel.instance({.id = id,
                            .statement = paper.at(label),
                            .words = "after the last collision",
                            .label = label,
                            .indices = {{"N_A", 1}, {"N_B", 1}}},
                           velocity, {{n, last}});
  };
  terminal("ratios.a_terminal", power.a, N_A, "eq:a-terminal");
  const Theorem b_terminal = terminal("ratios.b_terminal", power.b, N_B, "eq:b-terminal");

  // Appendix app:magic, the other way round: b_t = V only at a threshold alpha_k.
  const Theorem complete = kernel.hypothesis({.id = "ratios.complete",
                                              .statement = {b(N_B), V},
                                              .words = "suppose B takes everything",
                                              .indices = last_from_one});
  const ex scale = (2 + alpha) / (V * (1 + alpha));
  const Theorem magic_cosine = kernel.consequence({.id = "ratios.magic_cosine",
                                                   .statement = paper.at("eq:magic-b-cond"),
                                                   .words = "then the cosine is -1",
                                                   .label = "eq:magic-b-cond",
                                                   .indices = last_from_one},
                                                  {{b_terminal, scale}, {complete, -scale}});
  const ex last_angle = (N_B + one_half) * psi;
  const Theorem magic_angle = kernel.last_angle({.id = "ratios.magic_angle",
                                                 .statement = {last_angle, Pi},
                                                 .words = "and the angle is pi",
                                                 .indices = last_from_one},
                                                magic_cosine, counting.N_B);
  kernel.consequence(
      {.id = "ratios.magic_only",
       .statement = paper.at("eq:magic-b-cond-simple"),
       .words = "which is alpha_k with k = N_B: the magic ratios are the thresholds of A",
       .label = "eq:magic-b-cond-simple",
       .indices = last_from_one},
      {{magic_angle, 1 / psi}});

  // Appendix app:deficient: b_t = c_t only at a threshold beta_k.
  const Totals total = totals(kernel, power);
  const Theorem together = kernel.hypothesis(
      {.id = "ratios.together", .statement = {c_t, b_t}, .words = "suppose C ends up with B"});
  const Theorem momentum = kernel.consequence({.id = "ratios.together_momentum",
                                               .statement = {(1 + alpha) * b_t + a_t, V},
                                               .words = "momentum",
                                               .label = "app:deficient, momentum"},
                                              {{total.momentum, 1}, {together, -alpha}});
  const Theorem energy =
      kernel.consequence({.id = "ratios.together_energy",
                          .statement = {(1 + alpha) * pow(b_t, 2) + pow(a_t, 2), pow(V, 2)},
                          .words = "energy",
                          .label = "app:deficient, energy"},
                         {{total.energy, 1}, {together, -alpha * (c_t + b_t)}});
  const ex eliminated =
      ((1 + alpha) * pow(b_t, 2) + pow(V - (1 + alpha) * b_t, 2) - pow(V, 2)).expand();
  const ex remaining = (eliminated / (b_t * (1 + alpha))).normal();
  const Theorem quadratic =
      kernel.consequence({.id = "ratios.together_product",
                          .statement = {b_t * (1 + alpha) * remaining, 0},
                          .words = "a_t eliminated, factored"},
                         {{energy, 1}, {momentum, -(a_t + V - (1 + alpha) * b_t)}});
  const Theorem was_hit =
      kernel.hypothesis({.id = "ratios.was_hit",
                         .statement = {b_t, Relation::not_equal, 0},
                         .words = "b_t = 0 is the state before: B has been hit"});
  const Theorem linear = kernel.cancellation(
      {.id = "ratios.together_linear", .statement = {remaining, 0}, .words = "divided by b_t"},
      quadratic, b_t * (1 + alpha), was_hit);
  const Theorem b_value = kernel.consequence({.id = "ratios.together_b",
                                              .statement = paper.at("eq:defb-terminal"),
                                              .words = "B's terminal velocity",
                                              .label = "eq:defb-terminal"},
                                             {{linear, 1 / (2 + alpha)}});
  kernel.consequence({.id = "ratios.together_a",
                      .statement = paper.at("app:deficient, a_t"),
                      .words = "A's terminal velocity",
                      .label = "app:deficient, a_t"},
                     {{momentum, 1}, {b_value, -(1 + alpha)}});
  const Theorem last_of_B =
      kernel.hypothesis({.id = "ratios.last_of_B",
                         .statement = {b(N_B), b_t},
                         .words = "b_t is B's velocity after its last collision",
                         .indices = last_from_one});
  const Theorem deficient_cosine =
      kernel.consequence({.id = "ratios.deficient_cosine",
                          .statement = paper.at("eq:def-b-cond"),
                          .words = "so the cosine is that of psi/2, with a minus sign",
                          .label = "eq:def-b-cond",
                          .indices = last_from_one},
                         {{b_terminal, scale}, {last_of_B, -scale}, {b_value, -scale}});
  const Theorem deficient_angle = kernel.last_angle({.id = "ratios.deficient_angle",
                                                     .statement = {last_angle, Pi - psi / 2},
                                                     .words = "and the angle is pi - psi/2",
                                                     .indices = last_from_one},
                                                    deficient_cosine, counting.N_B);
  kernel.consequence({.id = "ratios.deficient_only",
                      .statement = paper.at("app:deficient, N_B"),
                      .words = "which is beta_k with k = N_B",
                      .label = "app:deficient, N_B",
                      .indices = last_from_one},
                     {{deficient_angle, 1 / psi}});

  return {magic.named,
          deficient.named,
          magic.stable,
          deficient.stable,
          {magic.angle, magic.ratio, magic_N_A, magic_N_B},
          {deficient.angle, deficient.ratio, deficient_N_A, deficient_N_B},
          magic_b};
}

}  // namespace magicmass::derivation
