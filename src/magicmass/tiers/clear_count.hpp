// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "magicmass/arithmetic/lanes.hpp"
#include "magicmass/batch/count_polynomials.hpp"

namespace magicmass::tiers {
inline namespace MAGICMASS_TARGET {

/// pi/h with cos h = 1/(1+alpha), of which the number of collisions is ceil(pi/h) - 1.
struct TurnsToPi {
  double quotient;
  double relative_error;  ///< at most this
};

/// For alpha below 1, or the least bit more.
[[gnu::always_inline]] inline TurnsToPi turns_to_pi(double alpha) {
  // pi/h = P(alpha)/sqrt(alpha). The root and the quotient do not wait for each other.
  const double inverse_root = arithmetic::square_root(alpha) * (1.0 / alpha);
  constexpr double least = 0x1p-20;
  if (alpha < least) {
    // What follows the square is below 2^-63; the minimax error is 7 2^-53, and there are 6 roundings.
    constexpr auto& c = batch::double_coefficients;
    const double quotient = (c[0] + alpha * (c[1] + alpha * c[2])) * inverse_root;
    return {quotient, 0x1p-48};
  }
  // The coefficients are those of P (1 - 7.5 2^-24)/2. Relative errors: of P 0.6 2^-24, of the double-precision operations
  // nothing; less than 2^-24 in all.
  constexpr double whole_P = 2.0 / (1 - 7.5 * 0x1p-24);
  constexpr auto& c = batch::single_coefficients;
  static_assert(std::size(c) == 8);
  const double square = alpha * alpha;
  const double P =
      ((double{c[0]} + double{c[1]} * alpha) + square * (double{c[2]} + double{c[3]} * alpha)) +
      (square * square) *
          ((double{c[4]} + double{c[5]} * alpha) + square * (double{c[6]} + double{c[7]} * alpha));
  const double quotient = (whole_P * P) * inverse_root;
  return {quotient, 0x1p-21};
}

/// The number of collisions where pi/h, less than 2^63, tells it, else 0.
[[gnu::always_inline]] inline std::int64_t clear_total(TurnsToPi turns) {
  const double unsure = turns.relative_error * turns.quotient;  // from 1/2 on nothing is certain
  const auto below = static_cast<std::int64_t>(turns.quotient);
  const double past = turns.quotient - static_cast<double>(below);
  return past > unsure && past < 1.0 - unsure ? below : 0;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::tiers
