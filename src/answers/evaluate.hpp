// SPDX-License-Identifier: GPL-2.0-or-later
// Theorems as formulas: a term of the book with numbers for its variables.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "answers/ball.hpp"
#include "kernel/expr.hpp"

namespace answers {

/// Values of variables and of whole terms, such as N_A.
using Values = std::map<kernel::Expr, Ball>;

/// The term as a ball; functions by their definitions in the book. Throws Undecided where the bits
/// do not do, std::logic_error for a function that the book does not define.
Ball evaluate(kernel::Expr term, Values values);
/// The right side of the equation that a theorem of the book is, or of its part.
kernel::Expr right_side(const std::string& id);

/// Calls with more and more bits until it says that all is certain; throws Undecided with this
/// message where that is not so with many times the bits of `digits` decimal digits.
void with_bits(int digits, const std::function<bool()>& is_certain, const std::string& otherwise);

}  // namespace answers
