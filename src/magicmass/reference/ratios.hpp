// SPDX-License-Identifier: GPL-2.0-or-later
// The independent oracle for magic and deficient mass ratios: CLN's pi and cosine at raised precision.
#pragma once

#include <concepts>
#include <string>

#include <cln/rational.h>

#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass::reference {

/// The k-th ratio, k >= 1, correctly rounded to `digits` significant decimal digits, in to_decimal's form.
/// Throws InvalidInput for k < 1 or digits < 1.
std::string ratio_digits(const Magic& ratio, int digits);
/// Likewise.
std::string ratio_digits(const Deficient& ratio, int digits);

/// The float, double or long double nearest to the k-th ratio, k >= 1. Throws InvalidInput for k < 1.
template <std::floating_point Float>
Float nearest_ratio(const Magic& ratio);
/// Likewise.
template <std::floating_point Float>
Float nearest_ratio(const Deficient& ratio);

/// A rational within relative 2^-bits of the k-th ratio, for measuring errors against.
cln::cl_RA ratio_within(const Magic& ratio, long bits);
/// Likewise.
cln::cl_RA ratio_within(const Deficient& ratio, long bits);

}  // namespace magicmass::reference
