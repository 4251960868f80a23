// SPDX-License-Identifier: GPL-2.0-or-later
// Events and trajectories as a table to read: five digits are enough to follow a run; the other formats have them all.
#pragma once

#include <string>
#include <vector>

#include "command/records.hpp"

namespace magicmass::command {

/// The names of the columns, each as wide as its numbers are.
std::string short_head(const std::vector<std::string>& columns);
/// One row; long fractions as decimals.
std::string short_row(const std::vector<std::string>& columns, const std::vector<Cell>& row);

}  // namespace magicmass::command
