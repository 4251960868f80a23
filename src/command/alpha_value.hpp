// SPDX-License-Identifier: GPL-2.0-or-later
// What a mass ratio, as its user wrote it, is worth.
#pragma once

#include "command/records.hpp"
#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass::command {

/// The double nearest to it. Throws Undecided where that is 0 or infinite.
double nearest_double(const MassRatio& alpha);

/// A double as a number, the others as text.
Cell alpha_cell(const MassRatio& alpha);

}  // namespace magicmass::command
