// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "magicmass/arithmetic/block.hpp"

namespace magicmass::batch {
inline namespace MAGICMASS_TARGET {

using Row = arithmetic::Lanes<arithmetic::widest>;
using RowBits = Row::Mask;  ///< as many 64-bit integers

[[gnu::always_inline]] inline RowBits load_bits(const void* from) {
  RowBits words;
  std::memcpy(&words, from, sizeof words);
  return words;
}

/// Whole numbers 0 <= n <= 2^51 as doubles; of others anything.
[[gnu::always_inline]] inline Row as_doubles(RowBits n) {
  const RowBits above_2_52 = n ^ (RowBits{} + std::bit_cast<std::int64_t>(0x1p52));
  return Row(std::bit_cast<Row::Doubles>(above_2_52)) - Row(0x1p52);
}

/// What the kernels take: 2^-120 <= alpha <= 2^60, 0 <= n <= 2^51, and n <= 1 from alpha = 1 on.
[[gnu::always_inline]] inline bool is_in_domain(double alpha, std::int64_t n) {
  return alpha >= 0x1p-120 && alpha <= 0x1p60 && n >= 0 &&
         n <= (alpha >= 1.0 ? 1 : std::int64_t{1} << 51U);
}
/// The same of many: a negative word of ratios, or a bit from 2^51 on in one of indices. Doubles compare like their bits, and
/// those of a negative double are negative; differences wrap, but of the two with alpha not both.
struct OutOfDomain {
  RowBits ratios{};
  RowBits indices{};

  [[gnu::always_inline]] void see(RowBits alpha, RowBits n) {
    using Unsigned [[gnu::vector_size(sizeof(RowBits))]] = std::uint64_t;
    const auto bits = [](double x) { return Unsigned{} + std::bit_cast<std::uint64_t>(x); };
    const auto a = std::bit_cast<Unsigned>(alpha), index = std::bit_cast<Unsigned>(n);
    ratios |= std::bit_cast<RowBits>((a - bits(0x1p-120)) | (bits(0x1p60) - a) |
                                     ((bits(1.0) - 1 - a) & (1 - index)));
    indices |= n;
  }
  [[gnu::always_inline]] bool is_any() const {
    std::int64_t ratio = 0, index = 0;
    for (int lane = 0; lane < arithmetic::widest; ++lane) {
      ratio |= ratios[lane];
      index |= indices[lane];
    }
    return (ratio < 0) | ((static_cast<std::uint64_t>(index) >> 51U) != 0);
  }
};

/// Where 2^-100 <= alpha <= 2^60 there are at most 2^51 cycles.
[[gnu::always_inline]] inline bool is_in_domain(double alpha) {
  return alpha >= 0x1p-100 && alpha <= 0x1p60;
}
[[gnu::always_inline]] inline RowBits out_of_domain(RowBits alpha) {
  using Unsigned [[gnu::vector_size(sizeof(RowBits))]] = std::uint64_t;
  const auto bits = [](double x) { return Unsigned{} + std::bit_cast<std::uint64_t>(x); };
  const auto a = std::bit_cast<Unsigned>(alpha);
  return std::bit_cast<RowBits>((a - bits(0x1p-100)) | (bits(0x1p60) - a));
}
[[gnu::always_inline]] inline bool has_negative(RowBits words) {
  std::int64_t all = 0;
  for (int lane = 0; lane < arithmetic::widest; ++lane) all |= words[lane];
  return all < 0;
}

/// Whether a number type left the rounding of row i open.
template <class Number>
[[gnu::always_inline]] inline bool is_open(const arithmetic::Certainty<Number>& certain,
                                           std::size_t i) {
  if constexpr (requires { certain.all; })
    return certain.all[i] == 0;
  else
    return false;
}
/// Calls one(i) for the rows i of a block that a number type left open and, where any is, for those out of a kernel's domain.
template <class Number, class IsOutside, class One>
[[gnu::always_inline]] inline void for_open_rows(std::size_t rows,
                                                 const arithmetic::Certainty<Number>& certain,
                                                 bool is_any_outside, IsOutside is_outside,
                                                 One one) {
  if (!is_any_outside && certain.is_all(0, rows)) return;
  for (std::size_t first = 0; first < rows; first += arithmetic::widest) {
    const std::size_t end = first + arithmetic::widest;
    if (!is_any_outside && certain.is_all(first, end)) continue;
    for (std::size_t i = first; i < end; ++i)
      if (is_open(certain, i) || (is_any_outside && is_outside(i))) one(i);
  }
}

template <class Number>
constexpr bool rounds_results = requires {
  typename Number::Result;
};

template <class Number>
constexpr bool rounding_is_tested = requires(arithmetic::Certainty<Number> certain) {
  certain.all;
};

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::batch
