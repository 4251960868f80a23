// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace magicmass::codegen {

// A matrix or column vector of the paper. The table in matrix_forms.cpp is the whole of generated/magicmass/cycle_matrices.hpp.
struct MatrixForm {
  std::string function;  // "Lambda"
  std::string summary;
  std::string domain;
  std::string error;
  std::string theorem;                     // one whose side is the matrix
  bool left_side = false;                  // that side is the left one
  std::string index = {};                  // "n", or empty
  bool exact = false;                      // for any field that has the root of alpha
  std::vector<std::string> bindings = {};  // theorem ids
};

const std::vector<MatrixForm>& matrix_forms();

}  // namespace magicmass::codegen
