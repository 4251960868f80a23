// SPDX-License-Identifier: GPL-2.0-or-later
// What the operators and functions of typed expressions make of numbers and matrices. All throw
// kernel::Refused, "column 7: ...", for what has no value or would be too large.
#pragma once

#include <string>
#include <vector>

#include "kernel/expr.hpp"
#include "notation/tokens.hpp"

namespace notation {
using kernel::Expr;

bool is_function(const std::string& name);
/// "sin(x)" of sinx, "sqrt(5)" of sqrt5: where what is left is an argument; else "".
std::string hidden_function(const std::string& name);
Expr applied(const std::string& function, Expr x);
cln::cl_RA number_of(const Token& token);
std::size_t bits(const cln::cl_RA& q);

Expr negative(Expr e);
Expr added(Expr a, Expr b, std::size_t column);  ///< of matrices
Expr times(Expr a, Expr b, std::size_t column);
Expr quotient(Expr a, Expr b, std::size_t column);
Expr raised_to(Expr base, Expr exponent, std::size_t column);
Expr ordered_root(Expr order, Expr x, std::size_t column);
Expr logarithm(Expr x, Expr base, std::size_t column);
Expr grid_of(const std::vector<kernel::Exprs>& rows, std::size_t column);
}  // namespace notation
