// SPDX-License-Identifier: GPL-2.0-or-later
#include "derivation/shorthand.hpp"

#include <ginac/ginac.h>

namespace magicmass::derivation {

const GiNaC::ex one_half = GiNaC::numeric(1, 2);

}  // namespace magicmass::derivation
