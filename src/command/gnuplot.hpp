// SPDX-License-Identifier: GPL-2.0-or-later
// Drawing by gnuplot, without any file: script and picture are passed in memory.
#pragma once

#include <string>

namespace command {

/// What gnuplot prints for a script. Throws answers::InvalidInput where gnuplot is not installed,
/// std::runtime_error with its first words where it cannot draw.
std::string drawn(const std::string& script);

}  // namespace command
