// SPDX-License-Identifier: GPL-2.0-or-later
// Exact decisions about real algebraic numbers: is this constant 0, and if not, on which side of it?
//
// The class: rational numbers; + - * /; integer powers; rational powers of numbers >= 0 (the real root); |x|; cos, sin
// and tan of rational multiples of Pi. GiNaC writes sec(x) as 1/cos(x).
//
//   sign_of(lhs - rhs).sign == 0     lhs and rhs are one and the same number: a proof, not a tolerance
#pragma once

#include <optional>
#include <string>

#include "algebraic/budget.hpp"
#include "magicmass/errors.hpp"

namespace GiNaC {
class ex;
}

namespace magicmass::algebraic {

/// The expression is no real number of the class above: a symbol or another function in it, a floating-point
/// number, a root of a negative number, a division by zero, a tangent at its pole. what() names that part.
struct NotAlgebraic : InvalidInput {
  using InvalidInput::InvalidInput;
};

/// What is known of a constant's sign.
struct Decision {
  std::optional<int> sign;   ///< -1, 0 or +1; nothing where the budget did not suffice
  std::string method;        ///< one sentence: how this is known, or why it is not
  long agreeing_digits = 0;  ///< undecided: so many decimals after the point are certainly 0
};

/// The sign of a constant, decided exactly. Zero is proved (by exact arithmetic with roots of unity and radicals, or
/// by a separation bound); a sign comes from rigorous interval arithmetic. Signs of radicands and divisors within
/// are decided in the same way. Throws NotAlgebraic. Never throws or hangs for want of budget: then there is no sign.
Decision sign_of(const GiNaC::ex& constant, const Budget& budget = {});

/// The constant rounded down and up to `digits` decimals after the point; equal but for the last digits.
struct Decimals {
  std::string below;  ///< not above the constant
  std::string above;  ///< not below it
};
/// A certified enclosure whose ends are at most 2 units of the last decimal apart. Throws NotAlgebraic, BeyondBudget.
Decimals decimals(const GiNaC::ex& constant, long digits, const Budget& budget = {});

}  // namespace magicmass::algebraic
