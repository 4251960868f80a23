// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "report/rounds.hpp"

namespace magicmass::report {

/// Additions of which each waits for the one before, so each takes one cycle whatever the clock rate is just then.
/// Nothing on processors for which this is not known.
std::optional<Timed> dependent_additions();

}  // namespace magicmass::report
