// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "codegen/ir.hpp"
#include "codegen/kernel_forms.hpp"

namespace magicmass::codegen {

// A kernel's file down to its struct: what it includes, its namespace, and where its formulas are from.
std::string kernel_opening(const KernelForm& form, const Program& program);

}  // namespace magicmass::codegen
