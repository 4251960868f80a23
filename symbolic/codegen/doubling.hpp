// SPDX-License-Identifier: GPL-2.0-or-later
// Sequences that are reached by doubling their index.
#pragma once

#include <string>

#include "codegen/hypotheses.hpp"
#include "codegen/plain_printer.hpp"

namespace codegen {
/// |- f(params, 0) = .., f(params, 1) = .., f(params, 2*m) by f(params, m), and f(params, 2*m + 1)
/// by f(params, m), f(params, m + 1) and f(params, 1), for every integer m.
struct Doubling {
  kernel::Theorem at_0, at_1, even, odd;
};
/// The function template that goes to f(params, 2n) and f(params, 2n + 1) in as many steps as n has
/// bits. Refused: theorems of another shape.
std::string emit_doubling(const Doubling& t, const Domain& d);
/// Names f(params, 2*x) and f(params, 2*x + 1) in a term; the lines that compute both.
std::string call_doubling(const Doubling& t, kernel::Expr term, PlainPrinter& printer);
}  // namespace codegen
