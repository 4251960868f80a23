// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include <cln/integer.h>

namespace magicmass::algebraic {

/// n / 10^digits, with all its `digits` >= 0 decimals: "-0.050" for -50 and 3.
std::string decimal_text(const cln::cl_I& n, long digits);

}  // namespace magicmass::algebraic
