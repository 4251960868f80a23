// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include <cln/rational.h>

#include "magicmass/reference/count.hpp"
#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass::reference {

/// Numbers of A-C and C-B collisions between equal blocks with restitution e, of any size; nullopt where they never
/// end. From special_cases.N_e, total = ceil(pi/h) - 1 with cos h = (1+e)/(2 sqrt(e) (1+alpha)), and collapse.alpha_c:
/// collapse where that is 1 or more. Exact: whether there is a collapse, and the counts where pi/h is whole, are
/// decided in rational numbers, all else with as many digits as it takes.
/// Throws InvalidInput unless alpha > 0 and 0 < e <= 1; Undecided if alpha is closer to a threshold than some 64 times
/// the digits that alpha and e have (never seen for rational ones; an irrational alpha may be on one).
std::optional<LargeCounts> count_collisions(const MassRatio& alpha, const cln::cl_RA& e);

}  // namespace magicmass::reference
