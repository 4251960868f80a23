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
const char* const exact_error = "none in an exact field";

std::vector<Form> angle_forms() {
  return {
      {.quantity = "angle",
       .name = "closed",
       .summary = "The angle psi of one cycle, as the paper writes it",
       .domain = "alpha > 0 and finite",
       .bound = {.ulp = 2},
       .real_inputs = {"alpha"},
       .outputs = {{"psi", "rotation.psi_paper"}}},
      {.quantity = "angle",
       .name = "product",
       .summary = "The angle psi of one cycle, from a quarter of it",
       .domain = normal_alpha,
       .bound = {.ulp = 2},
       .real_inputs = {"alpha"},
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
       .real_inputs = {"alpha"},
       .indices = {"j"},
       .outputs = {{"t", "times.t"}, {"s", "times.s"}},
       .bindings = {"rotation.psi_paper"}},
      {.quantity = "encounters",
       .name = "exact",
       .result = "Encounters",
       .summary = "Times and distances of the collisions as rational functions of alpha",
       .domain = encounter_domain,
       .error = exact_error,
       .real_inputs = {"alpha"},
       .indices = {"j"},
       .exact = true,
       .outputs = {{"t", "times.t_rational"}, {"s", "times.s_rational"}},
       .bindings = {"chebyshev.T_1"}},
      {.quantity = "encounters",
       .name = "product",
       .result = "Encounters",
       .summary = "Times and distances of the collisions, psi from a quarter of it",
       .domain = encounter_domain,
       .error = encounter_error,
       .real_inputs = {"alpha"},
       .indices = {"j"},
       .outputs = {{"t", "times.t"}, {"s", "times.s"}},
       .bindings = {"rotation.psi_half_angle"}},
      {.quantity = "encounters",
       .name = "tangent",
       .result = "Encounters",
       .summary = "Times and distances of the collisions from one sine and one cosine",
       .domain = "alpha normal and finite, not subnormal; 0 <= j < number of collisions",
       .error = "grows with j: a sum cancels where the next collision all but fails to take place,"
                " and may be 0 there",
       .real_inputs = {"alpha"},
       .indices = {"j"},
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
       .indices = {"k"},
       .outputs = {{"magic", "ratios.alpha_k_paper"}, {"deficient", "ratios.beta_k_paper"}}},
      {.quantity = "ratios",
       .name = "product",
       .result = "Ratios",
       .summary = "Magic and deficient mass ratios without cancellation",
       .domain = ratio_domain,
       .bound = {.ulp = 5},
       .indices = {"k"},
       .outputs = {{"magic", "ratios.alpha_k_stable"}, {"deficient", "ratios.beta_k_stable"}}},
  };
}

std::vector<Form> terminal_forms() {
  const auto cases = [](const std::string& name) {
    const std::string id = "offset." + name + "_after_";
    return FormOutput{name, id + "Q", {id + "P", id + "P_whole"}};
  };
  return {
      {.quantity = "terminal",
       .name = "offset",
       .result = "Terminal",
       .summary = "Terminal velocities from how far the last cycle is from a quarter turn",
       .domain = "alpha normal and finite, not subnormal; N_A and N_B its numbers of collisions",
       .bound = {.eps = 6},
       .error = "beyond alpha = 1, of V instead",
       .real_inputs = {"alpha"},
       .indices = {"N_A", "N_B"},
       .outputs = {cases("a"), cases("b"), cases("c"), {"rho", "offset.rho"}},
       .bindings = {"power.V_CM", "rotation.psi_half_angle", "tangent.tan_quarter",
                    "tangent.cot_half", "offset.is_P", "offset.r_t", "offset.b_after_Q",
                    "offset.b_after_P", "offset.b_after_P_whole"}},
  };
}

std::vector<Form> velocity_forms() {
  return {
      {.quantity = "velocities",
       .name = "closed",
       .result = "Velocities",
       .summary = "All velocities as the paper writes them",
       .domain = velocity_domain,
       .error = "nearly equal numbers are subtracted where a velocity is small",
       .real_inputs = {"alpha"},
       .indices = {"n"},
       .outputs =
           {{"a", "power.a"}, {"b", "power.b"}, {"c", "power.c"}, {"c_prime", "power.c_prime"}},
       .bindings = {"power.V_CM", "rotation.psi_paper"}},
      {.quantity = "velocities",
       .name = "exact",
       .result = "Velocities",
       .summary = "All velocities as rational functions of alpha",
       .domain = velocity_domain,
       .error = exact_error,
       .real_inputs = {"alpha"},
       .indices = {"n"},
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
       .real_inputs = {"alpha"},
       .indices = {"n"},
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
       .bound = {.eps = 6},
       .error = "beyond alpha = 1, of V instead; all up to the last collision",
       .real_inputs = {"alpha"},
       .indices = {"n"},
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
      {"Terminal",
       "After the last collision, velocities in units of V.",
       {{"a", "a_t, of A"},
        {"b", "b_t, of B"},
        {"c", "c_t, of C"},
        {"rho", "the fraction of the energy that B takes"}}},
      {"Encounters",
       "Collision j = 0 (P_1), 1 (Q_1), 2 (P_2), ...",
       {{"t", "its time, in units of L/V, from the first collision on"},
        {"s", "the distance from A to B then, in units of L"}}},
      {"Ratios",
       "The k-th threshold mass ratios.",
       {{"magic", "alpha_k, where B takes everything"},
        {"deficient", "beta_k, where C ends up with B"}}},
  };
  return all;
}

const std::vector<Form>& forms() {
  static const std::vector<Form> all = [] {
    std::vector<Form> collected;
    for (const std::vector<Form>& part :
         {angle_forms(), encounter_forms(), ratio_forms(), terminal_forms(), velocity_forms()})
      collected.insert(collected.end(), part.begin(), part.end());
    return collected;
  }();
  return all;
}

}  // namespace magicmass::codegen
