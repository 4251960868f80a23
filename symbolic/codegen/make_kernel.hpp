// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "codegen/emit.hpp"
#include "proof/theorem.hpp"

namespace magicmass::codegen {

// Throws InvalidInput for an id that is not there.
const proof::Theorem& theorem_named(const std::vector<proof::Theorem>& theorems,
                                    const std::string& id);

// Throws std::logic_error where the form says of its theorems what is not so: KernelForm::other_cases and first.
Kernel make_kernel(const KernelForm& form, const std::vector<proof::Theorem>& theorems);

}  // namespace magicmass::codegen
