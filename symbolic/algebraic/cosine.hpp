// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cln/rational.h>

#include "algebraic/interval.hpp"

namespace magicmass::algebraic {

/// cos(2 pi turn), to a relative width of about 2^-precision.
Interval cosine_of_turn(const cln::cl_RA& turn, long precision);

}  // namespace magicmass::algebraic
