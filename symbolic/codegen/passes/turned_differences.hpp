// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// -(x - y) becomes y - x where x - y has no other use, and so does a product that has such a difference as a factor; -(-x)
// becomes x. What is minus a named value has no name any more, and a program with none of these stays as it is.
Program turned_differences(const Program& program);

}  // namespace magicmass::codegen
