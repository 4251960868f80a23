// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "codegen/forms.hpp"
#include "codegen/ir.hpp"
#include "proof/theorem.hpp"

namespace magicmass::codegen {

// A form with its theorems and its program after the passes; one more for each output alone.
struct Evaluator {
  Form form;
  std::vector<std::vector<proof::Theorem>> outputs;  // each with all its cases
  std::vector<proof::Theorem> bindings;
  Program program;
  std::vector<Program> single;  // as many as outputs; the same program when there is one output
};

// Throws std::out_of_range when a theorem that the form needs is not among them, std::logic_error when
// cases of one output, or bindings of one symbol, have different right sides.
Evaluator make_evaluator(const Form& form, const std::vector<proof::Theorem>& theorems);

}  // namespace magicmass::codegen
