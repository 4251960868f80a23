// SPDX-License-Identifier: GPL-2.0-or-later
// One case of a quantity as a struct with three stages.
#pragma once

#include <string>
#include <vector>

#include "codegen/lower.hpp"

namespace codegen {
struct EmittedCase {
  std::string code;
  std::string errors;
  std::vector<std::string> bounds;  ///< of Accurate's outputs, in words
  std::vector<std::string> whole;   ///< whole outputs, then the others
  std::vector<std::string> real;
};
/// "  double a, b;"
std::string fields(const std::string& type, const std::vector<std::string>& names);
EmittedCase emit_case(const Quantity& q, const Case& c);
/// "in.alpha >= 0x1p-300 && ..." of the case, in both domains.
std::string condition(const Quantity& q, const Case& c);
}  // namespace codegen
