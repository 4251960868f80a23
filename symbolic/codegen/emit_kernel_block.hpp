// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "codegen/kernel_expression.hpp"
#include "codegen/kernel_forms.hpp"

namespace magicmass::codegen {

// What a kernel loads of an array: all inputs but those in the number type.
std::vector<std::string> loaded_inputs(const KernelForm& form);

// Whether a stage uses a value of an earlier one.
bool is_needed_in(int number, int stage, const Program& program, const Stages& stages,
                  const KernelForm& form);

// What a kernel says of the degrees of its results, where they are handed out one by one.
std::string emit_degrees(const KernelForm& form, const Program& program);

// The function over a block: a loop a stage, with the carried values, of these types, in between.
std::string emit_block(const KernelForm& form, const Program& program, const Stages& stages,
                       const KernelPrinter& printer, const std::map<int, std::string>& carried);

}  // namespace magicmass::codegen
