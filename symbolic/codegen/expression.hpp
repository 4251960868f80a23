// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// C++ for a program's nodes: temporaries for what is used twice or has a name, expressions for the rest.
struct Emitted {
  std::vector<std::string>
      lines;  // declarations, then temporaries with the formula each stands for
  std::vector<std::string> outputs;  // one expression an output
};

// `type` is the template parameter ("Real", "Field"). Functions of <cmath> are declared first and called by their bare
// names, so that a number type of one's own brings its own.
Emitted emit_expressions(const Program& program, const std::string& type);

// Broken after an operator so that no line is longer than 100 columns.
std::string wrapped(const std::string& line, std::size_t columns = 100);
/// And its end of line.
std::string wrapped_line(const std::string& line);

}  // namespace magicmass::codegen
