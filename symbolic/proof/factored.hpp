// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <ginac/ginac.h>

namespace magicmass::proof {

// GiNaC::factor(polynomial), which depends on nothing else: proofs ask for the same few polynomials, over and
// over, so the latest ones are remembered.
GiNaC::ex factored(const GiNaC::ex& polynomial);

}  // namespace magicmass::proof
