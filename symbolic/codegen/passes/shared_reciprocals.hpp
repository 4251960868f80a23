// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Takes a program after common_subexpressions. A reciprocal that several products use stays one division whose
// result they multiply by (one rounding more for each, within a unit in the last place); every other one is
// fused into its product as a division. No product of a reciprocal used once is left.
Program shared_reciprocals(const Program& program);

}  // namespace magicmass::codegen
