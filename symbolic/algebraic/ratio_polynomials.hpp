// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "algebraic/polynomial.hpp"

namespace magicmass::algebraic {

/// The minimal polynomial of sec(2 pi j/m) - 1 for every j prime to m, m >= 1 and m != 4, over the integers: primitive,
/// the leading coefficient positive; of degree phi(m)/2 for m > 2. Throws InvalidInput for other m.
Polynomial secant_polynomial(long m);

/// Of alpha_k = sec(pi/(2k+1)) - 1, k >= 1 (Ee & Lee, Table II). Throws InvalidInput for k < 1.
Polynomial magic_polynomial(long k);

/// Of beta_k = sec(pi/(2(k+1))) - 1, k >= 1. Throws InvalidInput for k < 1.
Polynomial deficient_polynomial(long k);

}  // namespace magicmass::algebraic
