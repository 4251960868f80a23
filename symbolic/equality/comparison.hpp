// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "equality/decide.hpp"
#include "equality/point.hpp"

namespace magicmass::equality {

// Both sides at one point.
struct PointComparison {
  enum class Outcome {
    differ,            // certainly
    left_not_defined,  // the left side alone is not, by more than a zero of a denominator
    right_not_defined,
    pole,     // one side alone divides by zero
    agree,    // as far as `digits` tell; exactly where is_exact
    neither,  // is defined
    unknown,
  };
  Outcome outcome = Outcome::unknown;
  bool is_exact = false;
  int digits = 0;
  Counterexample values = {};
};

// `exactly`: what balls leave open is put to the exact methods for constants.
PointComparison compare_at(const Point& point, const Tree& lhs, const Tree& rhs, bool exactly);

}  // namespace magicmass::equality
