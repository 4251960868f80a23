// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Takes any program. Integer powers become products, half-integer powers square roots times those, and
// products of constants one constant. No power is left. Values change by rounding only.
Program strength_reduction(const Program& program);

}  // namespace magicmass::codegen
