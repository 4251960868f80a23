// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "equality/expression.hpp"

namespace magicmass::equality {

// of_pi pi + sum of factor * function, where each function is asin, acos, atan or log of something.
struct LinearForm {
  cln::cl_RA of_pi = 0;
  std::vector<std::pair<cln::cl_RA, Tree>> terms = {};
  std::vector<Tree> rest = {};  // summands of another kind
};

LinearForm linear_form(const Tree& tree);

}  // namespace magicmass::equality
