// SPDX-License-Identifier: GPL-2.0-or-later
// A reader's own evaluator among the report's: a C++ file with `Velocities velocities(double alpha, long n)`.
#pragma once

#include <string>

#include "command/report/measurement.hpp"
#include "report/contestant.hpp"

namespace magicmass::command {

/// Its name in the tables.
inline constexpr const char* own_name = "yours";

/// Compiled, and called within this process: it is run as it stands, without the limits that `learn check` sets.
/// Throws InvalidInput, with the compiler's first complaint, where it does not compile.
report::Contestant own_function(const std::string& file);

/// Its places among all that compute velocities in double: "yours: everyday: place 3 of 14 by error, 5 of 14 by time";
/// a line a family.
std::vector<std::string> own_places(const Measurement& measurement);

}  // namespace magicmass::command
