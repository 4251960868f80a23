// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <cln/rational.h>

namespace magicmass::algebraic {

/// r > 0 as a product of powers with exponents other than 0 of small primes and of at most two larger numbers that
/// are not factored, what is left of the numerator and of the denominator.
std::vector<std::pair<cln::cl_I, long>> prime_powers(const cln::cl_RA& r);

}  // namespace magicmass::algebraic
