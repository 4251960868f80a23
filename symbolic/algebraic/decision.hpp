// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "algebraic/terms.hpp"

namespace magicmass::algebraic {

struct Verdict {
  int sign;
  std::string method;  ///< how it is known, one sentence
};

/// The budget ran out with the number known to be below 10^-agreeing_digits.
struct SignLeftOpen : BeyondBudget {
  SignLeftOpen(const std::string& message, long digits)
      : BeyondBudget(message), agreeing_digits(digits) {}
  long agreeing_digits;
};

/// The sign of a term, which it then keeps. Throws BeyondBudget.
Verdict decide(Terms& terms, std::size_t id, const Work& work);

}  // namespace magicmass::algebraic
