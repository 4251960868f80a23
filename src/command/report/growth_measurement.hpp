// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "command/report/progress.hpp"
#include "report/contestant.hpp"
#include "report/growth.hpp"
#include "report/oracle.hpp"
#include "report/timing.hpp"

namespace magicmass::command {

/// Appends how the contestants of one quantity do as the work grows: along its scales, against the length of the array
/// and, for velocities, the exact tier against the digits asked for. Ends early after Ctrl-C.
void measure_growth(const std::vector<report::Contestant>& contestants, bool quick,
                    report::Oracle& oracle, report::TimingPlan plan, Progress& progress,
                    std::vector<report::Growth>& growths);

}  // namespace magicmass::command
