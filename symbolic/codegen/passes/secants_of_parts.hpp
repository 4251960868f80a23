// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Takes a program without powers. 1/cos(pi/m) - 1 becomes one operation, which neither cancels nor needs an angle.
Program secants_of_parts(const Program& program);

}  // namespace magicmass::codegen
