// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "algebraic/interval.hpp"
#include "algebraic/polynomial.hpp"

namespace magicmass::algebraic {

/// An enclosure of its values on x.
Interval value(const Polynomial& polynomial, const Interval& x, long precision);

}  // namespace magicmass::algebraic
