// SPDX-License-Identifier: GPL-2.0-or-later
// Files that CMake puts into the program: the gnuplot scripts, the paper's numbers, exercises.
#pragma once

#include <map>
#include <string>

namespace host {

/// The text of a file by its path below this folder. Throws std::out_of_range where there is none.
std::string embedded(const std::string& file);
const std::map<std::string, std::string>& all_embedded();

}  // namespace host
