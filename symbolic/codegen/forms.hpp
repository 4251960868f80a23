// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace magicmass::codegen {

// One way to compute a quantity: which theorems give its outputs, and which say what their symbols are.
// The table in forms.cpp is the whole list; a new row appears in generated/, manifest, tests and report.
struct Form {
  std::string quantity;  // "velocities", "encounters", "ratios", "angle"
  std::string name;      // "closed", "product", "exact"
  std::string result;    // the struct in quantities.hpp; empty for a single number
  std::string summary;   // what it computes, for its docstring
  std::string domain;
  std::string error;       // stated error
  std::string real_input;  // "alpha", or empty
  std::string index;       // "n", "j", "k", or empty
  bool exact;              // for any field instead of float, double, long double
  std::vector<std::pair<std::string, std::string>> outputs;  // member -> theorem id
  std::vector<std::string> bindings;                         // theorem ids

  std::string function() const { return quantity + "_" + name; }
  std::string header() const { return "magicmass/" + function() + ".hpp"; }
};

const std::vector<Form>& forms();

// Structs that group outputs: name -> members with what they are.
struct QuantityStruct {
  std::string name;
  std::string words;
  std::vector<std::pair<std::string, std::string>> members;
};
const std::vector<QuantityStruct>& quantity_structs();

}  // namespace magicmass::codegen
