// SPDX-License-Identifier: GPL-2.0-or-later
// What restitution leaves of equal blocks: terminal velocities, or the time of a collapse.
#pragma once

#include <optional>
#include <string_view>

#include <cln/rational.h>

#include "magicmass/reference/count.hpp"
#include "magicmass/scenes/mass_ratio.hpp"
#include "magicmass/terminal.hpp"

namespace magicmass::command {

/// A coefficient of restitution as mass ratios are written: a double, or "p/q" exactly. Throws InvalidInput unless
/// it is above 0 and at most 1.
cln::cl_RA parse_restitution(std::string_view text);

/// How the motion ends: `counts` and `terminal`, or `collapse_time` in units of L/V.
struct InelasticEnd {
  std::optional<reference::LargeCounts> counts;
  Terminal terminal{};
  double collapse_time = 0.0;
};

/// For 0 < e <= 1. Counts, and whether there is a collapse, are exact; numbers are as good as those of
/// fast::terminal and fast::collapse_time. Throws Undecided where the counts do not fit 64 bits or alpha is closer to alpha_c(e) than
/// long double can tell.
InelasticEnd inelastic_end(const MassRatio& alpha, const cln::cl_RA& e);

}  // namespace magicmass::command
