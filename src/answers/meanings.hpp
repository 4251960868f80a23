// SPDX-License-Identifier: GPL-2.0-or-later
// What names stand for in the book.
#pragma once

#include <string>

#include "kernel/expr.hpp"

namespace answers {

/// The term with what the book defines written out: psi, theta, V_CM, alpha_k, beta_k, rho, a_n,
/// b_n, c_n, c'_n.
kernel::Expr written_out(kernel::Expr term);
/// The equation that defines such a name: "a_n", "c_prime_n", "beta_7"; nothing for another one.
kernel::Expr definition_of(const std::string& name);
/// The right side of the equation that a theorem of the book is.
kernel::Expr right_side(const std::string& id);

}  // namespace answers
