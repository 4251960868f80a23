// SPDX-License-Identifier: GPL-2.0-or-later
// Balls for mass ratios that are no rationals, with as many bits as it takes.
#pragma once

#include <functional>
#include <string>

#include "balls/ball.hpp"

namespace magicmass::scenes {

using balls::Ball;
using balls::decimal;
using balls::exact;
using balls::nearest_double;
using balls::NotCertain;

/// Calls with more and more bits until it says that all is certain; throws Undecided, so
/// many "bits would be needed" and `otherwise`, where that is not so with many times the bits of
/// `digits` decimal digits.
void until_certain(int digits, const std::function<bool()>& is_certain,
                   const std::string& otherwise);
/// What is computed with enough bits: until it is something, and does not throw Undecided.
template <class Compute>
auto with_bits(int digits, const Compute& compute, const std::string& otherwise = "") {
  decltype(std::optional(compute())) result;
  until_certain(
      digits, [&] { return (result = compute()).has_value(); }, otherwise);
  return *result;
}

}  // namespace magicmass::scenes
