// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Takes any program and the outputs that are wanted; keeps what they need and nothing else.
Program dead_code(const Program& program, const std::vector<std::string>& wanted);

}  // namespace magicmass::codegen
