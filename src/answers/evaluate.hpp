// SPDX-License-Identifier: GPL-2.0-or-later
// Theorems as formulas: a term of the book with numbers for its variables.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "kernel/expr.hpp"
#include "magicmass/scenes/ball.hpp"

namespace answers {

using magicmass::scenes::Ball;

/// Values of variables and of whole terms, such as N_A.
using Values = std::map<kernel::Expr, Ball>;

/// The term as a ball; functions by their definitions in the book. Throws NotCertain where the bits
/// do not do, std::logic_error for a function that the book does not define.
Ball evaluate(kernel::Expr term, Values values);
/// The right side of the equation that a theorem of the book is, or of its part.
kernel::Expr right_side(const std::string& id);

}  // namespace answers
