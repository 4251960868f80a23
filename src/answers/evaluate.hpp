// SPDX-License-Identifier: GPL-2.0-or-later
// Theorems as formulas: a term of the book with numbers for its variables.
#pragma once

#include <map>
#include <string>

#include "equality/constant.hpp"
#include "magicmass/scenes/ball.hpp"

namespace answers {

using magicmass::scenes::Ball;

/// Values of variables and of whole terms, such as N_A.
using Values = std::map<kernel::Expr, Ball>;

/// The term with what the book defines written out: psi, theta, V_CM, alpha_k, beta_k, rho, a_n,
/// b_n, c_n, c'_n, but for the terms of `values`.
kernel::Expr written_out(kernel::Expr term, const Values& values = {});
/// The equation that defines such a name: "a_n", "c_prime_n", "beta_7"; nothing for another one.
kernel::Expr definition_of(const std::string& name);
/// The term as a ball. Throws NotCertain where the bits do not do.
Ball evaluate(kernel::Expr term, const Values& values);
/// The right side of the equation that a theorem of the book is, or of its part.
kernel::Expr right_side(const std::string& id);

}  // namespace answers
