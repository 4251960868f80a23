// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "codegen/ir.hpp"

// Which passes run, and in which order.
namespace magicmass::codegen {

// All outputs through the passes that do not depend on which are wanted.
Program prepared(const Program& lowered);
// A prepared program through those that do.
Program finished(const Program& program, const std::vector<std::string>& wanted);
// All outputs wanted.
Program in_plain_numbers(const Program& lowered);
// Products as short as they can be: a kernel's number type rounds far below a double, so that their order is free.
Program for_kernel(const Program& lowered);
// The same where the one arctangent is psi/4.
Program for_kernel_with_arcsecant(const Program& lowered);

}  // namespace magicmass::codegen
