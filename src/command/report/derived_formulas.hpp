// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "codegen/forms.hpp"
#include "proof/theorem.hpp"

namespace GiNaC {
class ex;
}

namespace magicmass::command {

/// A form and its outputs as the theorems' right sides, in inputs_of alone and in the units of the outputs.
struct DerivedForm {
  codegen::Form form;
  std::shared_ptr<const std::vector<GiNaC::ex>> outputs;
};

/// A form's inputs by name, as its theorems call them: "alpha" and "n".
std::vector<std::string> inputs_of(const codegen::Form& form);

/// Throws InvalidInput when a theorem is not there, std::logic_error when a symbol without a value stays.
DerivedForm derived_form(const codegen::Form& form, const std::vector<proof::Theorem>& theorems);

/// The outputs in Python's syntax.
std::vector<std::string> outputs_in_python(const DerivedForm& derived);

/// All forms of these quantities but the exact ones.
std::vector<DerivedForm> derived_forms(const std::vector<proof::Theorem>& theorems,
                                       const std::vector<std::string>& quantities);

/// One line from which another process of the same program has the same forms without deriving them again.
std::string in_one_line(const std::vector<DerivedForm>& forms);
std::vector<DerivedForm> forms_from_line(const std::string& line);

}  // namespace magicmass::command
