// SPDX-License-Identifier: GPL-2.0-or-later
// From theorems to a program.
#pragma once

#include "codegen/hypotheses.hpp"
#include "codegen/program.hpp"

namespace codegen {
/// The case's program after all passes, for an evaluator. Refused: a theorem with a hypothesis that
/// does not follow from the intervals, a name without a definition, an operation that there is none
/// for, a divisor or root whose range is not known, a value that may over- or underflow.
Program lower(const Quantity& quantity, const Case& which, bool is_wide);
/// For a plain form, or (is_exact) one of any field. The outputs are entries where they are
/// matrices. Refused: as above; a function in an exact form.
Program lower_plain(const Quantity& quantity, const Case& which, bool is_exact);
}  // namespace codegen
