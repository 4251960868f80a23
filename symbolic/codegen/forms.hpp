// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace magicmass::codegen {

inline constexpr double no_bound = std::numeric_limits<double>::infinity();

// The largest error that a form promises, in two measures; what it does not promise is no_bound.
struct ErrorBound {
  double ulp = no_bound;  // in units in the last place of the exact value
  double eps = no_bound;  // in machine epsilons of the largest value of the body at that alpha <= 1
};

// One way to compute a quantity: which theorems give its outputs, and which say what their symbols are.
// The table in forms.cpp is the whole list; a new row appears in generated/, manifest, tests and demo.
struct Form {
  std::string quantity;     // "velocities", "encounters", "ratios", "terminal", ...
  std::string name;         // "closed", "product", "exact"
  std::string result = {};  // the struct in quantities.hpp; empty for a single number
  std::string summary;      // what it computes, for its docstring
  std::string domain;
  ErrorBound bound = {};
  std::string error = {};        // what is to be said of its error besides
  std::string real_input = {};   // "alpha", or empty
  std::string restitution = {};  // "e", or empty
  std::string index = {};        // "n", "j", "k", or empty
  bool exact = false;            // for any field instead of float, double, long double
  std::vector<std::pair<std::string, std::string>> outputs;  // member -> theorem id
  std::vector<std::string> bindings = {};                    // theorem ids

  std::string function() const { return quantity + "_" + name; }
  std::string header() const { return "magicmass/" + function() + ".hpp"; }
  std::string stated_error() const;  // bound and error in words
};

const std::vector<Form>& forms();

// Structs that group outputs: name -> members with what they are.
struct QuantityStruct {
  std::string name;
  std::string words;
  std::vector<std::pair<std::string, std::string>> members;
  std::vector<std::string> meaning =
      {};  // theorems that tie members that are definitions to the motion
};
const std::vector<QuantityStruct>& quantity_structs();

}  // namespace magicmass::codegen
