// SPDX-License-Identifier: GPL-2.0-or-later
// The data of the figures.
#pragma once

#include <string>
#include <vector>

#include "answers/table.hpp"

namespace answers {

struct Figure {
  std::string name;
  Table (*data)();
};
/// All figures, in the order of the paper.
const std::vector<Figure>& figures();

}  // namespace answers
