// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "proof/statement.hpp"

// The matrices of the paper's app:orthogonal and the linear algebra that the chapters use.
// Results are proposals: the kernel checks what is made of them.
namespace magicmass::derivation {

GiNaC::ex plane_rotation(const GiNaC::ex& phi);  // lambda(phi), 2 by 2
GiNaC::ex rotation_1(const GiNaC::ex& phi);      // eq:lambda-1
GiNaC::ex rotation_2(const GiNaC::ex& phi);      // eq:lambda-2
GiNaC::ex rotation_3(const GiNaC::ex& phi);      // eq:lambda-3
GiNaC::ex reflection_3();                        // diag[1, 1, -1]

GiNaC::ex transpose(const GiNaC::ex& matrix);
GiNaC::ex determinant(const GiNaC::ex& matrix);
GiNaC::ex unit(unsigned size);
GiNaC::ex cross(const GiNaC::ex& x, const GiNaC::ex& y);  // columns of three
GiNaC::ex columns(const std::vector<GiNaC::ex>& parts);

// A quotient that is linear in these elements, written as one: (factor x + factor y + ...)/denominator.
GiNaC::ex collected(const GiNaC::ex& quotient, const std::vector<GiNaC::ex>& elements);

// unknowns[i] = values[i], and unknowns[i] - values[i] = sum_j cofactors[i][j] (lhs_j - rhs_j):
// the second is what the kernel checks.
struct LinearSolution {
  std::vector<GiNaC::ex> values;
  std::vector<std::vector<GiNaC::ex>> cofactors;
};
// Throws std::runtime_error for a singular system.
LinearSolution solve_linear(const std::vector<proof::Statement>& equations,
                            const std::vector<GiNaC::ex>& unknowns);

// A column x with matrix * x = 0 whose first entry that can be chosen is 1, by elimination;
// `simplified` decides which pivots vanish. Throws std::runtime_error when the kernel of the matrix is not a line.
GiNaC::ex null_vector(const GiNaC::ex& matrix,
                      const std::function<GiNaC::ex(const GiNaC::ex&)>& simplified);

}  // namespace magicmass::derivation
