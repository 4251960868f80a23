// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Takes any program. Sorts the arguments of sums and products by what they are and by formula, and numbers the nodes
// as they are then reached from the outputs, so that the program no longer depends on the order in which GiNaC held them: constants, named values and inputs, sums,
// functions; in sums, what is subtracted comes last. Must run first; later passes keep the order.
Program canonical_order(const Program& program);

}  // namespace magicmass::codegen
