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
void with_bits(int digits, const std::function<bool()>& is_certain, const std::string& otherwise);

}  // namespace magicmass::scenes
