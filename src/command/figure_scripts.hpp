// SPDX-License-Identifier: GPL-2.0-or-later
// The gnuplot scripts of figures/*.gp, put into the program by CMake.
#pragma once

#include <string>

namespace command {

/// Throws std::out_of_range where there is none.
std::string figure_script(const std::string& name);

}  // namespace command
