// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "command/learn/exercise.hpp"

namespace magicmass::command {

/// A case with its doubles, and what the outputs are at just these doubles: to 64 bits, for a tolerance of half an
/// ulp and more.
struct ExpectedCase {
  Values labels;  ///< the inputs as the exercise writes them
  std::vector<double> inputs;
  std::vector<long double> outputs;
};

/// Every case of a code exercise. Throws InvalidInput where the content does not say what is expected.
std::vector<ExpectedCase> expected_cases(const Exercise& exercise);

}  // namespace magicmass::command
