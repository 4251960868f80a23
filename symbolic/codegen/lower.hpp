// SPDX-License-Identifier: GPL-2.0-or-later
// From theorems to a program: what must hold of a theorem before it is taken, and how it is read.
#pragma once

#include <functional>
#include <string>

#include "codegen/builder.hpp"

namespace codegen {
/// The interval of an input in a case.
Interval range_of(const Input& input, const Case& which, bool is_wide);

/// "alpha from 0x1p-300 to 0x1p+40, N_A(alpha) from 1 to 9", and the guards; is_exact: "alpha > 0".
std::string domain_in_words(const Quantity& q, const Case& c, bool is_exact = false);
struct Output {
  std::string name;
  bool is_whole;
  bool operator==(const Output&) const = default;
};
std::vector<Output> outputs_of(const Case& c);  ///< whole ones first
/// Refused: no case, cases of different outputs.
void check_outputs(const Quantity& q);

/// A case, and the range of each term there; Refused: a term of which none is known.
struct Domain {
  const Quantity& quantity;
  const Case& which;
  bool is_wide;
  std::function<Interval(kernel::Expr)> range;
};
/// Refused: a hypothesis that does not follow from the ranges.
void check_hypotheses(const Domain& d, const kernel::Exprs& hypotheses, kernel::Expr conclusion);
/// The left side of |- name(params) = term. Refused: another form, a hypothesis that does not
/// follow.
kernel::Expr head(const Domain& d, const kernel::Theorem& t);
/// Refused, too: a parameter that is no input, unit, or one-point interval.
kernel::Expr checked_head(const Domain& d, const kernel::Theorem& t);
/// The formula with names at their parameters in place of units: a_n, not a_n(alpha, 1).
std::string shown(const Quantity& q, kernel::Expr formula);
/// The function template that goes to f(params, 2n) and f(params, 2n + 1) in as many steps as n has
/// bits. Refused: theorems of another shape.
std::string emit_doubling(const Doubling& t, const Domain& d);
/// Makes f(params, 2*x) and f(params, 2*x + 1) in a term known; the lines that compute both.
std::string call_doubling(const Doubling& t, kernel::Expr term, Builder& terms);
/// The case's program after all passes; outputs of plain forms are entries where they are matrices.
/// Refused: a theorem with a hypothesis that does not follow from the intervals, a name without a
/// definition, an operation that there is none for, a divisor or root whose range is not known, a
/// value that may over- or underflow, a function of a field's numbers; quantity and case are named.
Program lower(const Quantity& quantity, const Case& which, Numbers numbers);
}  // namespace codegen
