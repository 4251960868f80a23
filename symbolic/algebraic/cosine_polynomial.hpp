// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "algebraic/polynomial.hpp"

namespace magicmass::algebraic {

/// The m-th cyclotomic polynomial, m >= 1: minimal polynomial of exp(2 pi i/m), irreducible by Gauss's theorem.
Polynomial cyclotomic_polynomial(long m);

/// The minimal polynomial of 2 cos(2 pi j/m) for every j prime to m, m >= 1; of degree phi(m)/2 for m > 2.
Polynomial cosine_polynomial(long m);

}  // namespace magicmass::algebraic
