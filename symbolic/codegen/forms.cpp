// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/forms.hpp"

#include <fmt/format.h>

namespace magicmass::codegen {
namespace {

const char* const velocity_domain =
    "alpha > 0 and finite; 0 <= n (c is proved for n >= 1 and is 0 at n = 0)";
// An infinity or a lost digit where alpha, or alpha V_CM, has fewer digits than the type.
const char* const product_domain =
    "alpha normal and finite, not subnormal; 0 <= n (c is proved for n >= 1 and is 0 at n = 0)";
const char* const normal_alpha = "alpha normal and finite, not subnormal";
const char* const encounter_domain = "alpha > 0 and finite; 0 <= j < number of collisions";
const char* const encounter_error = "grows with j: the sines are taken at angles up to pi";
const char* const ratio_domain = "k >= 1";
const char* const inelastic_domain =
    "0 < e <= 1; alpha > alpha_c(e), normal and finite; k such that these are all collisions, at "
    "least three: h close to pi/2 would cost digits";
const char* const inelastic_error =
    "in double at most 16 max(1/2, cond/2) ulp, where cond adds up the condition numbers in alpha "
    "and e";
const char* const exact_error = "none in an exact field";

std::vector<Form> angle_forms() {
  return {
      {.quantity = "angle",
       .name = "closed",
       .summary = "The angle psi of one cycle, as the paper writes it",
       .domain = "alpha > 0 and finite",
       .bound = {.ulp = 2},
       .real_input = "alpha",
       .outputs = {{"psi", "rotation.psi_paper"}}},
      {.quantity = "angle",
       .name = "product",
       .summary = "The angle psi of one cycle, from a quarter of it",
       .domain = normal_alpha,
       .bound = {.ulp = 2},
       .real_input = "alpha",
       .outputs = {{"psi", "rotation.psi_half_angle"}}},
  };
}

std::vector<Form> encounter_forms() {
  return {
      {.quantity = "encounters",
       .name = "closed",
       .result = "Encounters",
       .summary = "Times and distances of the collisions, psi as the paper writes it",
       .domain = encounter_domain,
       .error = encounter_error,
       .real_input = "alpha",
       .index = "j",
       .outputs = {{"t", "times.t"}, {"s", "times.s"}},
       .bindings = {"rotation.psi_paper"}},
      {.quantity = "encounters",
       .name = "exact",
       .result = "Encounters",
       .summary = "Times and distances of the collisions as rational functions of alpha",
       .domain = encounter_domain,
       .error = exact_error,
       .real_input = "alpha",
       .index = "j",
       .exact = true,
       .outputs = {{"t", "times.t_rational"}, {"s", "times.s_rational"}},
       .bindings = {"chebyshev.T_1"}},
      {.quantity = "encounters",
       .name = "product",
       .result = "Encounters",
       .summary = "Times and distances of the collisions, psi from a quarter of it",
       .domain = encounter_domain,
       .error = encounter_error,
       .real_input = "alpha",
       .index = "j",
       .outputs = {{"t", "times.t"}, {"s", "times.s"}},
       .bindings = {"rotation.psi_half_angle"}},
      {.quantity = "encounters",
       .name = "tangent",
       .result = "Encounters",
       .summary = "Times and distances of the collisions from one sine and one cosine",
       .domain = "alpha normal and finite, not subnormal; 0 <= j < number of collisions",
       .error = encounter_error,
       .real_input = "alpha",
       .index = "j",
       .outputs = {{"t", "tangent.t"}, {"s", "tangent.s"}},
       .bindings = {"power.V_CM", "rotation.psi_half_angle", "tangent.tan_quarter"}},
  };
}

std::vector<Form> ratio_forms() {
  return {
      {.quantity = "ratios",
       .name = "closed",
       .result = "Ratios",
       .summary = "Magic and deficient mass ratios as the paper writes them",
       .domain = ratio_domain,
       .error = "about 1 eps of 1, so no digit is left from k of about 1e8 on in double",
       .index = "k",
       .outputs = {{"magic", "ratios.alpha_k_paper"}, {"deficient", "ratios.beta_k_paper"}}},
      {.quantity = "ratios",
       .name = "product",
       .result = "Ratios",
       .summary = "Magic and deficient mass ratios without cancellation",
       .domain = ratio_domain,
       .bound = {.ulp = 5},
       .index = "k",
       .outputs = {{"magic", "ratios.alpha_k_stable"}, {"deficient", "ratios.beta_k_stable"}}},
  };
}

std::vector<Form> restitution_forms() {
  const auto after = [](const std::string& last, const std::string& collisions) {
    const std::string id = "inelastic_end.after_" + last + "_";
    return Form{
        .quantity = "terminal",
        .name = "after_" + last,
        .result = "TerminalValues",
        .summary = "With restitution e: velocities after " + collisions +
                   " collisions, of which a " + last + " is the last",
        .domain = inelastic_domain,
        .error = inelastic_error,
        .real_input = "alpha",
        .restitution = "e",
        .index = "k",
        .outputs = {{"a_t", id + "a_t"},
                    {"b_t", id + "b_t"},
                    {"c_t", id + "c_t"},
                    {"rho", id + "rho"}},
        .bindings = {"power.V_CM", "inelastic_end.h", "inelastic_end.alpha_c", id + "rest"}};
  };
  return {{.quantity = "collapse",
           .name = "product",
           .summary = "The time, in units of L/V, in which infinitely many collisions happen",
           .domain = "0 < e < 1, 0 < alpha < alpha_c(e) by more than a rounding: where the "
                     "collisions never end",
           .error = inelastic_error,
           .real_input = "alpha",
           .restitution = "e",
           .outputs = {{"t", "inelastic_end.t_infinity"}},
           .bindings = {"inelastic_end.alpha_c"}},
          after("P", "2k + 1"),
          after("Q", "2k"),
          {.quantity = "two_collisions",
           .name = "rational",
           .result = "TerminalValues",
           .summary = "With restitution e: velocities after P_1 and Q_1, the only collisions",
           .domain = "0 < e <= 1; alpha such that these are all collisions; (1 + alpha)^4 finite",
           .error = inelastic_error,
           .real_input = "alpha",
           .restitution = "e",
           .outputs = {{"a_t", "inelastic_end.two_a_t"},
                       {"b_t", "inelastic_end.two_b_t"},
                       {"c_t", "inelastic_end.two_c_t"},
                       {"rho", "inelastic_end.two_rho"}}}};
}

std::vector<Form> velocity_forms() {
  return {
      {.quantity = "velocities",
       .name = "closed",
       .result = "Velocities",
       .summary = "All velocities as the paper writes them",
       .domain = velocity_domain,
       .error = "nearly equal numbers are subtracted where a velocity is small",
       .real_input = "alpha",
       .index = "n",
       .outputs =
           {{"a", "power.a"}, {"b", "power.b"}, {"c", "power.c"}, {"c_prime", "power.c_prime"}},
       .bindings = {"power.V_CM", "rotation.psi_paper"}},
      {.quantity = "velocities",
       .name = "exact",
       .result = "Velocities",
       .summary = "All velocities as rational functions of alpha",
       .domain = velocity_domain,
       .error = exact_error,
       .real_input = "alpha",
       .index = "n",
       .exact = true,
       .outputs = {{"a", "chebyshev.a"},
                   {"b", "chebyshev.b"},
                   {"c", "chebyshev.c"},
                   {"c_prime", "chebyshev.c_prime"}},
       .bindings = {"power.V_CM", "chebyshev.T_1"}},
      {.quantity = "velocities",
       .name = "product",
       .result = "Velocities",
       .summary = "All velocities as products, psi from a quarter of it",
       .domain = product_domain,
       .bound = {.eps = 5},
       .error = "beyond alpha = 1, of V instead; all up to the last collision",
       .real_input = "alpha",
       .index = "n",
       .outputs = {{"a", "power.a_product"},
                   {"b", "power.b_product"},
                   {"c", "power.c_product"},
                   {"c_prime", "power.c_prime_product"}},
       .bindings = {"power.V_CM", "rotation.psi_half_angle"}},
      {.quantity = "velocities",
       .name = "tangent",
       .result = "Velocities",
       .summary = "All velocities from one sine and one cosine",
       .domain = product_domain,
       .bound = {.eps = 5},
       .error = "beyond alpha = 1, of V instead; all up to the last collision",
       .real_input = "alpha",
       .index = "n",
       .outputs = {{"a", "tangent.a"},
                   {"b", "tangent.b"},
                   {"c", "tangent.c"},
                   {"c_prime", "tangent.c_prime"}},
       .bindings = {"power.V_CM", "rotation.psi_half_angle", "tangent.tan_quarter",
                    "tangent.cot_half"}},
  };
}

}  // namespace

std::string Form::stated_error() const {
  std::string words;
  if (bound.ulp != no_bound) words = fmt::format("at most {} ulp", bound.ulp);
  if (bound.eps != no_bound)
    words = fmt::format("at most {} eps of the largest such value of the body at that alpha",
                        bound.eps);
  if (words.empty()) return error;
  return error.empty() ? words : words + "; " + error;
}

const std::vector<QuantityStruct>& quantity_structs() {
  static const std::vector<QuantityStruct> all{
      {"Velocities",
       "Velocities just after the n-th collisions, in units of V.",
       {{"a", "of A just after P_n"},
        {"b", "of B just after Q_n"},
        {"c", "of C just after P_n"},
        {"c_prime", "of C just after Q_n"}}},
      {"Encounters",
       "Collision j = 0 (P_1), 1 (Q_1), 2 (P_2), ...",
       {{"t", "its time, in units of L/V, from the first collision on"},
        {"s", "the distance from A to B then, in units of L"}},
       {"times.t_of_P", "times.t_of_Q", "times.s_of_P", "times.s_of_Q"}},
      {"Ratios",
       "The k-th threshold mass ratios.",
       {{"magic", "alpha_k, where B takes everything"},
        {"deficient", "beta_k, where C ends up with B"}}},
      {"TerminalValues",
       "Velocities after the last collision, in units of V, and what B got of the energy.",
       {{"a_t", "of A"}, {"b_t", "of B"}, {"c_t", "of C"}, {"rho", "(b_t/V)^2"}}},
      {"TerminalVelocities",
       "Velocities after the last collision, in units of V.",
       {{"a_t", "of A"}, {"b_t", "of B"}, {"c_t", "of C"}}},
  };
  return all;
}

const std::vector<Form>& forms() {
  static const std::vector<Form> all = [] {
    std::vector<Form> collected;
    for (const std::vector<Form>& part :
         {angle_forms(), encounter_forms(), ratio_forms(), restitution_forms(), velocity_forms()})
      collected.insert(collected.end(), part.begin(), part.end());
    return collected;
  }();
  return all;
}

}  // namespace magicmass::codegen
