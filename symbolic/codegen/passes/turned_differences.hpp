// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// -(x - y) becomes y - x where x - y has no other use, and so does a product that has such a difference as a factor; -(-x)
// becomes x. Names stay, and so does a program with none of these.
Program turned_differences(const Program& program);

}  // namespace magicmass::codegen
