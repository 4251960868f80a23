// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "render/formula.hpp"

namespace magicmass::render {

/// Words and the formulas among them.
struct Run {
  bool is_formula = false;
  std::string words = {};  // as they were written, a formula too
  Formula formula = {};
};
using Prose = std::vector<Run>;

/// "Lambda leaves it where it is", "n integer, n >= 1", "divide by M_1 (u_1 - v_1): ...": whole clauses that are
/// relations, and single words that can be nothing but symbols, become formulas; the rest stays as it is.
Prose prose(std::string_view words);

}  // namespace magicmass::render
