// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "magicmass/arithmetic/lanes.hpp"
#include "magicmass/batch/count_polynomials.hpp"

namespace magicmass::tiers {
inline namespace MAGICMASS_TARGET {

/// The number of collisions, ceil(pi/h) - 1 with cos h = 1/(1+alpha), where that is below 2^13 and single precision tells it;
/// else 0. alpha below 1, or the least bit more.
[[gnu::always_inline]] inline std::int64_t clear_total(double alpha) {
  // pi/h = P(alpha)/sqrt(alpha), with the coefficients of P (1 - 7.5 2^-24)/2. Relative errors: of P 0.6 2^-24, of the root's
  // reciprocal 2^-22.5, of the double-precision operations nothing; less than 2^-22 in all.
  constexpr double whole_P = 2.0 / (1 - 7.5 * 0x1p-24);
  constexpr double margin = 0x1p-21;
  constexpr auto& c = batch::single_coefficients;
  static_assert(std::size(c) == 8);
  if (!(alpha >= 0x1p-23)) [[unlikely]]
    return 0;
  const double square = alpha * alpha;
  const double P =
      ((double{c[0]} + double{c[1]} * alpha) + square * (double{c[2]} + double{c[3]} * alpha)) +
      (square * square) *
          ((double{c[4]} + double{c[5]} * alpha) + square * (double{c[6]} + double{c[7]} * alpha));
  const double quotient = (whole_P * P) * arithmetic::reciprocal_square_root_estimate(alpha);
  const auto below = static_cast<std::int64_t>(quotient);
  const double past = quotient - static_cast<double>(below);
  const double unsure = margin * quotient;
  return past > unsure && past < 1.0 - unsure ? below : 0;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::tiers
