// SPDX-License-Identifier: GPL-2.0-or-later
// Sequences that are reached by doubling their index.
#pragma once

#include <string>

#include "codegen/hypotheses.hpp"
#include "codegen/terms.hpp"

namespace codegen {
/// The function template that goes to f(params, 2n) and f(params, 2n + 1) in as many steps as n has
/// bits. Refused: theorems of another shape.
std::string emit_doubling(const Doubling& t, const Domain& d);
/// Makes f(params, 2*x) and f(params, 2*x + 1) in a term known; the lines that compute both.
std::string call_doubling(const Doubling& t, kernel::Expr term, Terms& terms);
}  // namespace codegen
