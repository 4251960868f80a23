// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// A product that is used once, in a product, becomes part of it, and the constants of a product become one: (1/2) n (4 x) is
// 2 n x. The value is the same; where products are rounded it need not be, so this is for kernels of number types
// that round far below a double.
Program flat_products(const Program& program);

}  // namespace magicmass::codegen
