// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/matrix_forms.hpp"

namespace magicmass::codegen {

const std::vector<MatrixForm>& matrix_forms() {
  static const std::vector<MatrixForm> all{
      {.function = "Lambda",
       .summary = "One cycle, V_n = Lambda V_(n-1): a rotation",
       .domain = "alpha > 0, (1 + alpha)^2 finite; a field needs sqrt(alpha)",
       .error = "each entry within 4 eps of 1; none in an exact field",
       .theorem = "cycle.Lambda",
       .exact = true},
      {.function = "R",
       .summary = "The frame in which Lambda turns about the third axis, its axis the last column",
       .domain = "alpha > 0 and finite",
       .error = "each entry within 4 eps of 1",
       .theorem = "rotation.R"},
      {.function = "V_n_exact",
       .summary = "The vector of the velocities after n cycles, in units of V",
       .domain = "alpha > 0 and finite; 0 <= n; a field needs sqrt(alpha)",
       .error = "none in an exact field",
       .theorem = "cycle.V",
       .left_side = true,
       .index = "n",
       .exact = true,
       .bindings = {"chebyshev.a", "chebyshev.b", "chebyshev.c_prime", "power.V_CM",
                    "chebyshev.T_1"}},
      {.function = "V_n_tangent",
       .summary = "The vector of the velocities after n cycles, in units of V",
       .domain = "alpha normal and finite, not subnormal; 0 <= n <= N_B",
       .error = "each entry within 10 eps of 1, the length of the vector",
       .theorem = "cycle.V",
       .left_side = true,
       .index = "n",
       .bindings = {"tangent.a", "tangent.b", "tangent.c_prime", "power.V_CM",
                    "rotation.psi_half_angle", "tangent.tan_quarter", "tangent.cot_half"}},
  };
  return all;
}

}  // namespace magicmass::codegen
