// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/reference/velocities.hpp"

namespace magicmass::report {

/// Enclosures of a_n, b_n, c_n and c'_n for alpha > 0 and n >= 1, as reference::enclosed_velocities gives them, from
/// the same collision law, at a fifth of its cost: velocities relative to each other are two numbers, not three,
/// and with the ball's scaled by about sqrt(alpha) a cycle's map has entries of about 1, so that intervals widen by
/// about two bits a squaring however small alpha is. `precision` fraction bits throughout.
reference::CycleVelocities<reference::Interval> enclosed_velocities(const cln::cl_RA& alpha,
                                                                    const cln::cl_I& n,
                                                                    long precision);

}  // namespace magicmass::report
