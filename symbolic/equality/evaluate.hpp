// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>

#include "equality/ball.hpp"
#include "equality/expression.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::equality {

// The expression is certainly not defined. `isolated`: by a zero of a denominator alone, so that it may well be
// defined all round.
struct NotDefined : InvalidInput {
  NotDefined(const std::string& reason, bool isolated_)
      : InvalidInput(reason), isolated(isolated_) {}
  bool isolated;
};

// Whether it is defined, or its value, is not certain at this precision.
struct NotCertain : Undecided {
  using Undecided::Undecided;
};

// The sign of a constant, exactly, where that is known to be possible; asked only where balls leave it open.
using ExactSign = std::function<std::optional<int>(const Tree&)>;

// An enclosure of a constant: a tree without symbols. Throws NotDefined, NotCertain.
Ball evaluate(const Tree& constant, const BallArithmetic& arithmetic, const ExactSign& exact_sign);

// The same with so many digits, and with exact signs only where they are needed.
Ball evaluate_to(const Tree& constant, int digits, const ExactSign& exact_sign);

}  // namespace magicmass::equality
