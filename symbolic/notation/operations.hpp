// SPDX-License-Identifier: GPL-2.0-or-later
// What the operators and functions of typed expressions make of numbers and matrices. All throw
// kernel::Refused, "column 7: ...", for what has no value or would be too large.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "kernel/expr.hpp"
#include "notation/tokens.hpp"

namespace notation {
using kernel::Expr;

bool is_function(const std::string& name);
/// Of sinx, sin_2 and f in f(x): why it is no name of a number, and what may be meant; else "".
std::string why_no_symbol(const std::string& word, bool is_before_bracket,
                          const std::set<std::string>& factors);
/// What a function is of x, as one types it: "sin(x)/cos(x)"; "" of those that stay as they are.
const std::string& definition_of(const std::string& function);
cln::cl_RA number_of(const Token& token);
std::size_t bits(const cln::cl_RA& q);

Expr negative(Expr e);
Expr sum_of(const kernel::Exprs& terms, std::size_t column);
Expr times(Expr a, Expr b, std::size_t column);
Expr quotient(Expr a, Expr b, std::size_t column);
Expr raised_to(Expr base, Expr exponent, std::size_t column);
Expr ordered_root(Expr order, Expr x, std::size_t column);
/// Of numbers, or of matrices, one below the other: [[a, b], [c, d]].
Expr grid_of(const std::vector<kernel::Exprs>& rows, std::size_t column);
}  // namespace notation
