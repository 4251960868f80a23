// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>

#include "magicmass/reference/interval.hpp"
#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass::reference {

/// A real number as a source of enclosures: called with a precision p >= 1 it returns one at that precision, of
/// width at most 2^(2-p).
using Enclosure = std::function<Interval(long precision)>;

/// A rational number.
Enclosure enclosure(const cln::cl_RA& x);

/// Any mass ratio: rationals as they are; magic:k as sec(pi/(2k+1)) - 1 and deficient:k as sec(pi/(2(k+1))) - 1
/// (Ee & Lee, Table II) from CLN's pi and cos. Magic:1 is the number 1.
Enclosure enclosure(const MassRatio& alpha);

}  // namespace magicmass::reference
