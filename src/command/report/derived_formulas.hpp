// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "codegen/forms.hpp"
#include "proof/theorem.hpp"

namespace GiNaC {
class ex;
}

namespace magicmass::command {

/// A form's inputs by name, as its theorems call them: "alpha" and "n".
std::vector<std::string> inputs_of(const codegen::Form& form);

/// The outputs of a form as the theorems' right sides, in inputs_of alone and in the units of the outputs. Throws
/// std::out_of_range when a theorem is not there, std::logic_error when another symbol stays.
std::vector<GiNaC::ex> derived_outputs(const codegen::Form& form,
                                       const std::vector<proof::Theorem>& theorems);

/// The same in Python's syntax.
std::vector<std::string> derived_outputs_in_python(const codegen::Form& form,
                                                   const std::vector<proof::Theorem>& theorems);

}  // namespace magicmass::command
