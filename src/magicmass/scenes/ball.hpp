// SPDX-License-Identifier: GPL-2.0-or-later
// Balls for mass ratios that are no rationals, with as many bits as it takes.
#pragma once

#include <optional>
#include <string>

#include "balls/ball.hpp"
#include "magicmass/numbers/errors.hpp"

namespace magicmass::scenes {

using balls::Ball;
using balls::decimal;
using balls::exact;
using balls::nearest_double;
using balls::NotCertain;

/// What is computed, with more and more bits until it is something. Throws Undecided, so many "bits
/// would be needed" and `otherwise`, where many times the bits of `digits` decimal digits are too
/// few.
template <class Compute>
auto with_bits(int digits, const Compute& compute, const std::string& otherwise = "") {
  const int wanted = 4 * digits;
  const int most = 8192 + 4 * wanted;  // a double near 2^-1074 with its count takes some 3,000
  for (int bits = 128 + wanted; bits <= most; bits *= 2) {
    Ball::set_bits(bits);
    try {
      if (const auto result = std::optional(compute())) return *result;
    } catch (const NotCertain&) {
    }
  }
  throw Undecided("more than " + std::to_string(most) + " bits would be needed" + otherwise);
}

}  // namespace magicmass::scenes
