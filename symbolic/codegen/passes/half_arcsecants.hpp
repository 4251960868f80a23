// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "codegen/ir.hpp"

namespace magicmass::codegen {

// Takes a program whose one arctangent is psi/4, with cos(psi/2) = 1/(1 + alpha): that becomes asec(1 + alpha)/2, with the
// tangent kept beside. Throws std::logic_error if there is none or another.
Program half_arcsecants(const Program& program);

}  // namespace magicmass::codegen
