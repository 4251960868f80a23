// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "magicmass/arithmetic/lanes.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/tiers/clear_count.hpp"

namespace magicmass::tiers {
inline namespace MAGICMASS_TARGET {

/// The number of collisions of an alpha below 1, ceil(pi/h) - 1, from h/2 as a pair within the relative error given; 0 where
/// that does not tell it, or it is 2^63 or more.
[[gnu::always_inline]] inline std::int64_t total_from_angle(TurnsToPi turns,
                                                            arithmetic::Pair<double> half_h,
                                                            double relative_error) {
  if (!(turns.quotient < 0x1p63)) [[unlikely]]
    return 0;
  // pi/h = m + (pi - m h)/h for the whole number m nearest to what is known of it; m h is at most h/2, or 2^-48 of it, from pi, and
  // the high parts subtract exactly.
  const auto m = static_cast<std::int64_t>(turns.quotient + 0.5);
  const auto turned = half_h * (2.0 * static_cast<double>(m));
  const auto pi = arithmetic::Pair<double>::pi();
  const double rest = (pi.high - turned.high) + (pi.low - turned.low);
  // of m h the angle's error and a pair's, of the rest its last rounding
  const double unsure = 4.0 * (relative_error + 0x1p-98) + std::fabs(rest) * 0x1p-51;
  if (turns.relative_error * turns.quotient < 0.25) [[likely]] {  // pi/h is between m - 1 and m + 1
    if (!(std::fabs(rest) > unsure)) [[unlikely]]
      return 0;
    return m - (rest < 0.0);
  }
  // 1/h is known as q/pi
  const double q_per_pi = turns.quotient * 0x1.45f306dc9c883p-2;
  const double past = rest * q_per_pi;
  const double nearest = arithmetic::nearest_whole(past);
  const double from_nearest = past - nearest;
  const double unsure_past = unsure * q_per_pi + std::fabs(past) * (2.0 * turns.relative_error);
  if (!(std::fabs(from_nearest) > unsure_past && unsure_past < 0.25)) [[unlikely]]
    return 0;
  const std::uint64_t total = static_cast<std::uint64_t>(m) +
                              static_cast<std::uint64_t>(static_cast<std::int64_t>(nearest)) -
                              (from_nearest < 0.0);
  return total < std::uint64_t{1} << 63U ? static_cast<std::int64_t>(total) : 0;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::tiers
