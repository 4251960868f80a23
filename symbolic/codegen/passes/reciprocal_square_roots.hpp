// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Takes a program without powers. The reciprocal of a square root becomes one operation; a square root that is used
// elsewhere too stays.
Program reciprocal_square_roots(const Program& program);

}  // namespace magicmass::codegen
