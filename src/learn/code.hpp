// SPDX-License-Identifier: GPL-2.0-or-later
// A program as an answer. Who judges it does not know how it is run.
#pragma once

#include <functional>

#include "learn/exercise.hpp"

namespace learn {

using Numbers = std::vector<double>;
using Rows = std::vector<Numbers>;

struct Ran {
  std::string unread = {};   ///< why it was not compiled
  std::string stopped = {};  ///< why it came no further: "it crashed"
  Rows rows = {};            ///< what it gave for each case, as far as it came
};
/// Runs an answer to the exercise: a row of inputs is a case.
using Run = std::function<Ran(const Exercise&, const std::string& code, const Rows& inputs)>;

}  // namespace learn
