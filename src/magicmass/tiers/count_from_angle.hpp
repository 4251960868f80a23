// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "magicmass/arithmetic/lanes.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/sine_cosine.hpp"

namespace magicmass::tiers {
inline namespace MAGICMASS_TARGET {

/// The number of collisions of an alpha below 1, ceil(pi/h) - 1, from h/2 as a pair within the relative error given; 0 where
/// that does not tell it, or it is 2^63 or more.
[[gnu::always_inline]] inline std::int64_t total_from_angle(arithmetic::Pair<double> half_h,
                                                            double relative_error) {
  using arithmetic::half_pi;
  // Three roundings, and what the pair leaves out: within 2^-51. Up to 2^32 the conversions are exact.
  const double quotient = half_pi[0] / (half_h.high + half_h.low);
  if (quotient < 0x1p32) [[likely]] {
    const auto below = static_cast<std::int64_t>(quotient);
    const double past = quotient - static_cast<double>(below);
    const double unsure = quotient * (0x1p-50 + relative_error);
    if (past > unsure && past < 1.0 - unsure) [[likely]]
      return below;
  }
  // A pair's quotient and half a turn are good to 2^-100; what is left of it beside a whole number is rounded once.
  const auto q = arithmetic::Pair<double>(half_pi[0], half_pi[1]) / normalised(half_h);
  if (!(q.high < 0x1p63)) return 0;
  auto beside = static_cast<std::int64_t>(q.high);
  double of_high = q.high - static_cast<double>(beside);
  if (of_high > 0.5) {
    of_high -= 1.0;
    ++beside;
  }
  const double of_low = arithmetic::nearest_whole(q.low);
  beside += static_cast<std::int64_t>(of_low);
  const double past = of_high + (q.low - of_low);
  const double unsure = q.high * (0x1p-98 + relative_error) + std::fabs(past) * 0x1p-52;
  if (!(std::fabs(past) > unsure && std::fabs(past) < 1.0 - unsure)) return 0;
  return past > 0.0 ? beside : beside - 1;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::tiers
