// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// A product of some of another product's factors is computed once: with t S in one place, 2 t S x becomes 2 (t S) x.
Program shared_products(const Program& program);

}  // namespace magicmass::codegen
