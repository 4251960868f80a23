// SPDX-License-Identifier: GPL-2.0-or-later
// Tier `accurate`, one by one and by the batch on every instruction set, against certified arithmetic, which shares no number
// type with it; and both against the report's oracle, which shares no formula with either.
#pragma once

#include <string>
#include <vector>

#include "long_run/tally.hpp"
#include "report/contestant.hpp"

namespace magicmass::long_run {

using Inputs = std::vector<report::Input>;

/// "velocities", "encounters", "angle", "terminal" or "ratios".
Tally checked(const std::string& quantity, const Inputs& inputs);

/// Tier `accurate` on every `every`-th of them. Not for several threads at once: CLN is not made for that.
Tally against_oracle(const std::string& quantity, const Inputs& inputs, std::size_t every);

}  // namespace magicmass::long_run
