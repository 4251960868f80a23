// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/contestant.hpp"

namespace magicmass::report {

/// How often a contestant needed certified arithmetic, on inputs of the easiest family.
struct Fallbacks {
  std::string contestant, quantity, family;
  std::size_t asked = 0, fell_back = 0;
};

/// A row for each contestant that tells; no exact values are needed, so there may be many more inputs than for errors.
std::vector<Fallbacks> count_fallbacks(const std::vector<Contestant>& contestants,
                                       std::size_t inputs);

}  // namespace magicmass::report
