// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "codegen/ir.hpp"
#include "proof/theorem.hpp"

namespace magicmass::codegen {

// What a program computes: outputs by name, and the theorems that say what symbols on their right sides
// stand for ("V_CM = V/(2 + alpha)", "T(1) = 1/(1 + alpha)").
struct Source {
  std::vector<std::pair<std::string, proof::Theorem>> outputs;
  std::vector<proof::Theorem> bindings;
  std::vector<std::string> real_inputs;  // "alpha"
  std::string index;                     // "n": the integer input, if there is one
  std::vector<std::string> units = {};   // symbols that are 1 in the units of the outputs: "V", "L"
  // A symbol that is 1 or -1. What has it as a factor is not negative: it is the magnitude of the rest.
  std::string sign = {};
  bool left_sides = false;  // the outputs are the theorems' left sides instead, of what is bound
};

// The right sides as a program, before any pass; a matrix as an output an entry, row by row ("entry_11"). Throws std::logic_error for a symbol that is neither an
// input nor bound, or an expression that has no operation here.
Program lower(const Source& source);

}  // namespace magicmass::codegen
