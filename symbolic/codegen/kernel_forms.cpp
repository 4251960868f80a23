// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/kernel_forms.hpp"

namespace magicmass::codegen {

const std::vector<KernelForm>& kernel_forms() {
  static const std::vector<KernelForm> all{
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
