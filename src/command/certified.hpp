// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "magicmass/reference/enclosure.hpp"

namespace magicmass::command {

/// A real number, given by enclosures, rounded to `digits` significant decimal digits, every digit certain.
/// It must not be zero, nor halfway between two such decimals: throws Undecided where no precision tells.
std::string certified_decimal(const reference::Enclosure& value, int digits,
                              long starting_precision);

/// The same rounded to the nearest double.
double certified_double(const reference::Enclosure& value, long starting_precision);

}  // namespace magicmass::command
