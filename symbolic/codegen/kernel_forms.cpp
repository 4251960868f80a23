// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/kernel_forms.hpp"

namespace magicmass::codegen {

const std::vector<KernelForm>& kernel_forms() {
  static const std::vector<KernelForm> all{
      {.name = "angle",
       .kernel = "AngleKernel",
       .summary = "The angle psi of one cycle",
       .domain = "alpha > 0 and finite, of a single double",
       .reals = {"alpha"},
       .outputs = {{"psi", "tangent.psi"}},
       .bindings = {"tangent.tan_from_root", "tangent.root"}},
      {.name = "encounters",
       .kernel = "EncountersKernel",
       .result = "Encounters",
       .summary = "Time and distance at a collision",
       .domain = "alpha > 0 of a single double; 0 <= j < number of collisions, j < 2^51",
       .reals = {"alpha"},
       .integers = {"j"},
       .outputs = {{"t", "tangent.t_product"}, {"s", "tangent.s_product"}},
       .bindings = {"tangent.psi", "tangent.tan_from_root", "tangent.root"},
       .first = {"tangent.first_t", "tangent.first_s"}},
      {.name = "ratios",
       .kernel = "RatiosKernel",
       .result = "Ratios",
       .summary = "Magic and deficient mass ratios",
       .domain = "1 <= k < 2^50",
       .integers = {"k"},
       .outputs = {{"magic", "ratios.alpha_k_from_sine"}, {"deficient", "ratios.beta_k_from_sine"}}},
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
       .first = {"tangent.first_a", "tangent.first_b", "tangent.first_c", "tangent.first_c_prime"}},
  };
  return all;
}

}  // namespace magicmass::codegen
