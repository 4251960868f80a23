// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "magicmass/arithmetic/lanes.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

namespace detail {
/// coefficients[first], ..., coefficients[first + count - 1] as a polynomial; powers[k] = z^(2^k).
template <std::size_t first, std::size_t count, class T, std::size_t size, std::size_t steps>
[[gnu::always_inline]] inline T estrin(const double (&coefficients)[size],
                                       const std::array<T, steps>& powers) {
  if constexpr (count == 1) {
    return T(coefficients[first]);
  } else {
    constexpr std::size_t step = std::bit_width(count - 1) - 1;
    constexpr std::size_t lower = std::size_t{1} << step;
    return estrin<first, lower>(coefficients, powers) +
           estrin<first + lower, count - lower>(coefficients, powers) * powers[step];
  }
}
}  // namespace detail

/// A polynomial in z by Estrin's scheme: short chains, no fused operation, the same order everywhere.
template <class T, std::size_t size>
[[gnu::always_inline]] inline T polynomial(const double (&coefficients)[size], T z) {
  constexpr std::size_t steps = std::bit_width(size - 1);
  std::array<T, steps> powers;
  powers[0] = z;
  for (std::size_t k = 1; k < steps; ++k) powers[k] = powers[k - 1] * powers[k - 1];
  return detail::estrin<0, size>(coefficients, powers);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
