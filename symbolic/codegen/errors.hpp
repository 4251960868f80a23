// SPDX-License-Identifier: GPL-2.0-or-later
// Error analysis: each node's |computed - exact|, from the table of operations alone.
#pragma once

#include "codegen/form.hpp"
#include "codegen/operations.hpp"

namespace codegen {
struct Analysis {
  std::vector<Form> error;    ///< of each node
  std::vector<double> loose;  ///< of its low part, against its high part
  std::vector<double> spill;  ///< how much larger its low part may be; sums that cancel end it
  /// Of each result: what its rounding test is given; above that a sign is certain; 0 of others.
  std::vector<Form> outputs;
  std::vector<std::string> steps;  ///< one line a node, for a reader
};
/// Refused: a bound that is not known where it is needed, a fact or a range that is not known to
/// hold of computed values.
Analysis analyse(const Program& p, const NumberType& type, Plan& plan);
}  // namespace codegen
