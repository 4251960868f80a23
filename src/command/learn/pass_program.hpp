// SPDX-License-Identifier: GPL-2.0-or-later
// For exercises that ask for a pass of the generator: a program of the generator as C++ that a student's pass can take.
#pragma once

#include <string>

#include "command/learn/exercise.hpp"

namespace magicmass::command {

/// The program as the pass finds it, lowered from the theorems.
struct PassProgram {
  std::string
      header;  ///< C++: a function program_before() with the nodes, in Program and Node of the starter
  std::string
      json;  ///< {"before": 82, "after": 30}: how many nodes the generator's own pass finds and leaves
};

/// Derived once, however often it is asked for. Throws InvalidInput for theorems or passes that are not there.
const PassProgram& pass_program(const Exercise& exercise);

/// The names of the passes that an exercise may ask for.
inline const std::vector<std::string>& pass_names() {
  static const std::vector<std::string> names{"common_subexpressions", "dead_code"};
  return names;
}

}  // namespace magicmass::command
