// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "magicmass/evaluators/multiword.hpp"

namespace magicmass {

/// The bits of a magnitude below bit number `bit`.
template <std::size_t Words>
std::array<std::uint64_t, Words> bits_below(const std::array<std::uint64_t, Words>& words,
                                            int bit) {
  std::array<std::uint64_t, Words> low{};
  for (std::size_t i = 0; i < Words; ++i) {
    const int kept = bit - static_cast<int>(64 * i);
    if (kept >= 64) {
      low[i] = words[i];
    } else if (kept > 0) {
      low[i] = words[i] & ((std::uint64_t{1} << static_cast<unsigned>(kept)) - 1);
    }
  }
  return low;
}

/// A lower bound of a magnitude.
template <std::size_t Words>
typename Multiword<Words>::Bound lower_bound(const std::array<std::uint64_t, Words>& words) {
  using Bound = typename Multiword<Words>::Bound;
  for (std::size_t i = Words; i-- > 0;) {
    if (words[i] != 0) {
      return std::ldexp(static_cast<Bound>(words[i]) * (1 - Bound{0x1p-50}),
                        static_cast<int>(64 * i));
    }
  }
  return 0;
}

/// A number of which it is known that it is a multiple of 2^-grid: exactly that multiple as soon as the bound is below
/// half of 2^-grid, unchanged before.
template <std::size_t Words>
Multiword<Words> on_grid(const Multiword<Words>& x, int grid) {
  using Bound = typename Multiword<Words>::Bound;
  constexpr int bits = static_cast<int>(64 * Words);
  const auto grid_bit = [grid](const Multiword<Words>& y) {  // of 2^-grid in y.words
    return bits - 64 * y.exponent - grid;
  };
  if (!(x.error < std::ldexp(Bound{1}, grid_bit(x) - 1)) || grid_bit(x) >= bits) {
    return x;
  }
  Multiword<Words> result = x;
  result.error = 0;
  if (grid_bit(x) <= 0) {
    return result;
  }
  result = result + multiword<Words>(1, -grid - 1, x.negative);
  const int bit = grid_bit(result);
  if (bit < 0) {
    return x;  // a carry moved the grid out of the last word
  }
  const auto low = bits_below(result.words, bit);
  for (std::size_t i = 0; i < Words; ++i) {
    result.words[i] -= low[i];
  }
  result.error = 0;
  normalise(result);
  return result;
}

/// The double nearest to the true number, ties to even, subnormals as they are spaced, infinity past the largest, a
/// zero of its sign below the smallest; nullopt where the bound does not tell. It does where no boundary, half way
/// between two doubles, is within the bound of the stored number. The boundary looked at is the one in the stored
/// number's binade; just below a power of two they are twice as close, so the bound has to be less than a quarter of
/// the spacing besides.
template <std::size_t Words>
std::optional<double> nearest_double(const Multiword<Words>& x) {
  if (x.is_exact_zero()) {
    return 0.0;
  }
  using Bound = typename Multiword<Words>::Bound;
  constexpr int bits = static_cast<int>(64 * Words);
  const int base = 64 * x.exponent - bits;  // words[0] has the weight 2^base
  const int highest = base + bits - 1 - std::countl_zero(x.top());
  const int last = std::max(highest - 52, -1074);  // weight of the double's last place
  const int bit = last - base;                     // where it is in the words
  const bool has_sign = x.error * words_down<Bound>(Words) < size_below(x);
  if (!has_sign || !(x.error < std::ldexp(Bound{1}, bit - 2))) {
    return std::nullopt;
  }
  if (bit - 1 > bits) {  // below a quarter of the smallest double
    return x.negative ? -0.0 : 0.0;
  }
  const auto word = [&x](int i) {
    return i < bits ? x.words[static_cast<std::size_t>(i / 64)] : 0;
  };
  const auto offset = static_cast<unsigned>(bit % 64);
  const std::uint64_t whole =
      offset == 0 ? word(bit) : word(bit) >> offset | word(bit + 64) << (64U - offset);
  // below it: a half bit, and less than a half
  const bool half = ((word(bit - 1) >> static_cast<unsigned>((bit - 1) % 64)) & 1U) != 0;
  auto below = bits_below(x.words, bit - 1);
  bool up = half;
  if (x.error == 0) {
    if (half && lower_bound(below) == 0) {
      up = (whole & 1U) != 0;
    }
  } else {
    if (!half) {
      complement(below);
      below = bits_below(below, bit - 1);
    }
    const bool is_double = !half && lower_bound(below) == 0;
    if (!is_double && !(x.error < lower_bound(below))) {
      return std::nullopt;
    }
  }
  const double magnitude = std::ldexp(static_cast<double>(whole + (up ? 1 : 0)), last);
  return x.negative ? -magnitude : magnitude;
}

}  // namespace magicmass
