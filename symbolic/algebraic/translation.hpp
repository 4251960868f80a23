// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "algebraic/terms.hpp"

namespace GiNaC {
class ex;
}

namespace magicmass::algebraic {

/// A constant of the class (see constant.hpp) as a term, the signs of all its radicands and divisors decided.
/// Throws NotAlgebraic, BeyondBudget.
std::size_t translate(const GiNaC::ex& constant, Terms& terms, const Work& work);

}  // namespace magicmass::algebraic
