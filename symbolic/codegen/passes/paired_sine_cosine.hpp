// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Takes a program after common_subexpressions. Puts the sine and the cosine of one angle next to each other,
// so that one call computes both. Changes no value.
Program paired_sine_cosine(const Program& program);

}  // namespace magicmass::codegen
