// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "magicmass/counts.hpp"

namespace magicmass::report {

/// What is left after the last elastic collision, in units of V: the quantity elastic_terminal.
template <class Real>
struct Ending {
  Real a_t, b_t, c_t;
  Counts counts;
};

}  // namespace magicmass::report
