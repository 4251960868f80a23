// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Takes a canonically ordered program. Nodes with the same operation and the same arguments become one, and
// products that differ in a constant share the rest: pi/(2 k + 1) serves (1/2) pi/(2 k + 1) too. A name given
// to a value stays with it. Powers of two scale exactly, so this changes values by rounding at most.
Program common_subexpressions(const Program& program);

// The first half of it alone: nodes with the same operation and the same arguments become one, and no value changes.
Program without_repetitions(const Program& program);

}  // namespace magicmass::codegen
