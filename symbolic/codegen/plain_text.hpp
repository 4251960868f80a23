// SPDX-License-Identifier: GPL-2.0-or-later
// A program in C++ of any number type.
#pragma once

#include <set>
#include <string>

#include "codegen/program.hpp"

namespace codegen {
/// Values that a theorem names, or that are used more than once, have a line; all others stand
/// where they are used.
class PlainText {
public:
  explicit PlainText(const Program& program);
  std::set<std::string> functions;  ///< of <cmath>, that were printed

  /// The node where it is used. How strongly an operation binds: 1 a sum, 2 a product, 3 a name.
  std::string use(int k, int binding = 1);
  /// What the node is, whether or not it has a line.
  std::string right_side(int k, int binding = 1);
  std::string lines();

private:
  const Program& p;
  std::vector<int> uses;

  bool has_line(int k) const;
  std::string call(const std::string& function, const std::string& x);
};
}  // namespace codegen
