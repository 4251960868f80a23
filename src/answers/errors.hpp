// SPDX-License-Identifier: GPL-2.0-or-later
// What an answer throws instead; what() is one line, fit to be shown.
#pragma once

#include "magicmass/numbers/errors.hpp"

namespace answers {

using magicmass::InvalidInput;  ///< exit code 2
using magicmass::Undecided;     ///< exit code 3

}  // namespace answers
