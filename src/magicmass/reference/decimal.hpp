// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include <cln/rational.h>

namespace magicmass::reference {

/// x rounded to `digits` >= 1 significant decimal digits, to nearest, ties to even; all of them are written, also
/// trailing zeros. Plain ("0.00012", "123.40") where 1e-5 <= |x| < 10^digits, else scientific ("1.2e-7"); 0 is "0".
/// Throws InvalidInput for digits < 1.
std::string to_decimal(const cln::cl_RA& x, int digits);

}  // namespace magicmass::reference
