// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "equality/expression.hpp"

namespace GiNaC {
class ex;
}

namespace magicmass::equality {

// A scalar expression of the kernel's class as a tree. Throws std::logic_error for any other.
Tree from_ginac(const GiNaC::ex& e);

}  // namespace magicmass::equality
