// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/kernel_forms.hpp"

namespace magicmass::codegen {

std::string KernelForm::first_sine() const {
  return first_index.empty() ? "cot_half" : "Number(" + first_index + ")";
}

std::string KernelForm::first_cosine() const {
  const std::string one = "Number(Real(1.0))";
  return first_index.empty() ? one
                             : "select(" + first_index + " > Real(0.0), cot_half, " + one + ")";
}

namespace {

// The n-th cycle.
KernelForm velocities_at(const std::string& n) {
  const auto id = [&n](const char* name) { return std::string("fixed_n.") + name + "_" + n; };
  return {.name = "velocities_at_" + n,
          .kernel = "VelocitiesAt" + n + "Kernel",
          .result = "Velocities",
          .summary = "All velocities at n = " + n + ", rational in alpha",
          .domain = "2^-120 <= alpha <= 2^60",
          .reals = {"alpha"},
          .outputs = {{"a", id("a")}, {"b", id("b")}, {"c", id("c")}, {"c_prime", id("c_prime")}},
          .bindings = {"fixed_n.mu", "fixed_n.nu", "fixed_n.p_1", "fixed_n.q_2", "fixed_n.p_2",
                       "fixed_n.q_3"}};
}

}  // namespace

const std::vector<KernelForm>& kernel_forms() {
  static const std::vector<KernelForm> all{
      {.name = "angle",
       .kernel = "AngleKernel",
       .summary = "The angle psi of one cycle",
       .domain = "alpha > 0 and finite, of a single double",
       .reals = {"alpha"},
       .outputs = {{"psi", "tangent.psi"}},
       .bindings = {"tangent.tan_from_root", "tangent.root"},
       .arcsecant = "rotation.cos_half_psi"},
      {.name = "encounters",
       .kernel = "EncountersKernel",
       .result = "Encounters",
       .summary = "Time and distance at a collision",
       .domain = "alpha > 0 of a single double; 0 <= j < number of collisions, j < 2^51",
       .reals = {"alpha"},
       .integers = {"j"},
       .outputs = {{"t", "tangent.t_product"}, {"s", "tangent.s_product"}},
       .bindings = {"tangent.psi", "tangent.tan_from_root", "tangent.root"},
       .first = {"tangent.first_t", "tangent.first_s"},
       .first_index = "j",
       .arcsecant = "rotation.cos_half_psi"},
      {.name = "first_encounter",
       .kernel = "FirstEncounterKernel",
       .result = "Encounters",
       .summary = "Time and distance at Q_1",
       .domain = "alpha > 0; of a pair the results are the nearest doubles, (1 + alpha)/2 being "
                 "rounded once",
       .reals = {"alpha"},
       .outputs = {{"t", "tangent.first_t"}, {"s", "tangent.first_s"}}},
      {.name = "ratios",
       .kernel = "RatiosKernel",
       .result = "Ratios",
       .summary = "Magic and deficient mass ratios",
       .domain = "1 <= k < 2^50",
       .integers = {"k"},
       .outputs = {{"magic", "ratios.alpha_k_from_sine"},
                   {"deficient", "ratios.beta_k_from_sine"}}},
      {.name = "ratios_of_parts",
       .kernel = "RatiosOfPartsKernel",
       .result = "Ratios",
       .summary = "Magic and deficient mass ratios, of one k",
       .domain = "k >= 1, a whole number",
       .numbers = {"k"},
       .outputs = {{"magic", "ratios.alpha_k"}, {"deficient", "ratios.beta_k"}}},
      {.name = "terminal",
       .kernel = "TerminalKernel",
       .result = "TerminalValues",
       .summary = "Velocities after the last collision, and the energy that B takes",
       .domain = "2^-120 <= alpha <= 2^60 in lanes, any positive alpha of a single double; N_A of "
                 "that alpha, below 2^51; turn = 1 if N_B = N_A and -1 if N_B = N_A - 1",
       .reals = {"alpha"},
       .integers = {"N_A", "turn"},
       .outputs = {{"a_t", "offset.a_after_Q"},
                   {"b_t", "offset.b_product_after_Q"},
                   {"c_t", "offset.c_after_Q"},
                   {"rho", "offset.rho"}},
       .bindings = {"tangent.psi", "tangent.tan_from_root", "tangent.root", "offset.r_from_turn",
                    "offset.b_product_after_Q"},
       .other_cases = {{"a_t", {"offset.a_after_P", "offset.a_after_P_whole"}},
                       {"b_t", {"offset.b_product_after_P", "offset.b_product_after_P_whole"}},
                       {"c_t", {"offset.c_after_P", "offset.c_after_P_whole"}}},
       .first = {"tangent.first_a", "tangent.first_b", "tangent.first_c_prime"},
       .arcsecant = "rotation.cos_half_psi",
       .is_counted = true},
      {.name = "terminal_from_one",
       .kernel = "TerminalFromOneKernel",
       .result = "TerminalVelocities",
       .summary = "Velocities after the last of two collisions, in rows",
       .domain = "1 <= alpha <= 2^60",
       .reals = {"alpha"},
       .outputs = {{"a_t", "tangent.first_a_of_cosine"},
                   {"b_t", "tangent.first_b_of_cosine"},
                   {"c_t", "tangent.first_c_prime_of_cosine"}},
       .bindings = {"tangent.cos_half"},
       .rounds_results = true},
      {.name = "terminal_in_rows",
       .kernel = "TerminalInRowsKernel",
       .result = "TerminalVelocities",
       .summary = "Velocities after the last of more than two collisions, in rows",
       .domain = "2^-120 <= alpha < 1; N_A of that alpha, below 2^51",
       .reals = {"alpha"},
       .integers = {"N_A"},
       .outputs = {{"a_t", "offset.a_after_Q"},
                   {"b_t", "offset.b_from_momentum_after_Q"},
                   {"c_t", "offset.c_from_momentum_after_Q"}},
       .bindings = {"tangent.psi", "tangent.tan_quarter", "offset.r_from_turn", "offset.velocity_A",
                    "offset.momentum_C"},
       .other_cases =
           {{"a_t", {"offset.a_after_P", "offset.a_after_P_whole"}},
            {"b_t", {"offset.b_from_momentum_after_P", "offset.b_from_momentum_after_P_whole"}},
            {"c_t", {"offset.c_from_momentum_after_P", "offset.c_from_momentum_after_P_whole"}}},
       .is_counted = true,
       .not_negative = {"offset.not_negative_after_Q", "offset.not_negative_after_P",
                        "offset.not_negative_after_P_whole"},
       .rounds_results = true,
       .small_angle = {"offset.at_most_after_Q", "offset.at_most_after_P",
                       "offset.at_most_after_P_whole"}},
      {.name = "transmission",
       .kernel = "TransmissionKernel",
       .summary =
           "The fraction of the energy that reaches B, with restitution e between equal blocks",
       .domain =
           "alpha_c(e) < alpha <= 2^240, 2^-120 <= alpha; 2^-400 <= e <= 1; N collisions of all, N "
           "< 2^51; root_e = sqrt(e); decay = root_e^N; is_odd and is_even of N: 0 or 1",
       .reals = {"alpha"},
       .integers = {"N", "is_odd", "is_even"},
       .numbers = {"root_e", "decay"},
       .outputs = {{"rho", "transmission.rho_after_Q"}},
       .bindings = {"power.V_CM", "transmission.rest_e", "transmission.h",
                    "transmission.tan_half_h", "transmission.root_h", "transmission.alpha_c"},
       .other_cases = {{"rho", {"transmission.rho_after_P"}}}},
      {.name = "two_collisions",
       .kernel = "TwoCollisionsKernel",
       .summary =
           "The fraction of the energy that reaches B where P_1 and Q_1 are the only collisions",
       .domain = "2^-120 <= alpha <= 2^240, 0 < e <= 1",
       .reals = {"alpha", "e"},
       .outputs = {{"rho", "inelastic_end.two_rho"}}},
      {.name = "velocities",
       .kernel = "VelocitiesKernel",
       .result = "Velocities",
       .summary = "All velocities from one root, one arctangent and one sine-cosine pair",
       .domain = "2^-120 <= alpha <= 2^60 in lanes, any positive alpha of a single double; 0 <= n "
                 "<= N_A, n < 2^51",
       .reals = {"alpha"},
       .integers = {"n"},
       .outputs = {{"a", "tangent.a"},
                   {"b", "tangent.b_product"},
                   {"c", "tangent.c"},
                   {"c_prime", "tangent.c_prime"}},
       .bindings = {"tangent.psi", "tangent.tan_from_root", "tangent.root"},
       .first = {"tangent.first_a", "tangent.first_b", "tangent.first_c", "tangent.first_c_prime"},
       .first_index = "n",
       .arcsecant = "rotation.cos_half_psi"},
      {.name = "velocities_in_rows",
       .kernel = "VelocitiesInRowsKernel",
       .result = "Velocities",
       .summary = "All velocities as sums of a mean and a swing",
       .domain = "2^-120 <= alpha <= 2^60; 0 <= n <= N_A, n < 2^51, and n = 1 from alpha = 1 on",
       .reals = {"alpha"},
       .integers = {"n"},
       .outputs = {{"a", "tangent.a_sum"},
                   {"b", "tangent.b_sum"},
                   {"c", "tangent.c_sum"},
                   {"c_prime", "tangent.c_prime_sum"}},
       .bindings = {"tangent.psi", "tangent.tan_from_root", "tangent.root", "tangent.chord",
                    "tangent.ball_mean", "tangent.ball_swing"},
       .first = {"tangent.first_a", "tangent.first_b", "tangent.first_c", "tangent.first_c_prime"},
       .first_index = "n",
       .rounds_results = true},
      velocities_at("1"),
      velocities_at("2"),
  };
  return all;
}

}  // namespace magicmass::codegen
