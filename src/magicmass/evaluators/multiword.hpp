// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace magicmass {

/// A real number known to within a bound: a floating-point number of `Words` 64-bit words,
///
///     +- (words[0] + words[1] 2^64 + ... + words[Words-1] 2^(64 (Words-1))) 2^(64 (exponent - Words)),
///
/// with its top word not 0 unless all are, and an upper bound on |stored - true| in units of words[0]. The bound is 0
/// as long as no bit that is not 0 was cut off, so exact results are known to be exact; otherwise it is a
/// floating-point number that only ever grows by more than its own rounding. Infinity and NaN certify nothing.
template <std::size_t Words>
struct Multiword {
  static_assert(Words >= 2);
  using Magnitude = std::array<std::uint64_t, Words>;  // least significant word first
  /// Reaches 2^(64 Words), as much as there is to lose.
  using Bound = std::conditional_t<(Words < 15), double, long double>;

  Magnitude words{};
  int exponent = 0;
  bool negative = false;
  Bound error = 0;

  std::uint64_t top() const { return words[Words - 1]; }
  bool is_exact_zero() const { return top() == 0 && error == 0; }
};

__extension__ using Wide = unsigned __int128;

/// The error of an inexact result from a bound that a few sums and products of nonnegative numbers gave: they are off
/// by less than 2^-50 relative and by less than 2^-500 where one underflows.
template <std::floating_point Bound>
Bound grown(Bound bound) {
  return bound * (1 + Bound{0x1p-50}) + Bound{0x1p-500};
}

/// 2^(-64 words), or for double an upper bound of it from 16 words on.
template <std::floating_point Bound>
Bound words_down(std::size_t words) {
  if constexpr (std::is_same_v<Bound, double>) {
    constexpr std::uint64_t bias = 1023;
    return std::bit_cast<double>((bias - 64 * (words < 15 ? words : 15)) << 52U);
  } else {
    return std::ldexp(Bound{1}, -static_cast<int>(64 * words));
  }
}

/// Upper and lower bound of the stored magnitude in units of 2^(64 exponent): between 2^-64 and 1 unless 0.
template <std::size_t Words>
double size_above(const Multiword<Words>& x) {
  const double leading =
      static_cast<double>(x.top()) + (static_cast<double>(x.words[Words - 2]) + 1.0) * 0x1p-64;
  return x.top() == 0 ? 0.0 : leading * (0x1p-64 * (1.0 + 0x1p-50));
}
template <std::size_t Words>
double size_below(const Multiword<Words>& x) {
  const double leading =
      static_cast<double>(x.top()) + static_cast<double>(x.words[Words - 2]) * 0x1p-64;
  return leading * (0x1p-64 * (1.0 - 0x1p-50));
}

/// magnitude 2^bit, exactly.
template <std::size_t Words>
Multiword<Words> multiword(std::uint64_t magnitude, int bit = 0, bool negative = false) {
  Multiword<Words> result;
  if (magnitude == 0) {
    return result;
  }
  const int shift = bit & 63;
  const Wide wide = Wide{magnitude} << static_cast<unsigned>(shift);
  const auto high = static_cast<std::uint64_t>(wide >> 64U);
  const auto low = static_cast<std::uint64_t>(wide);
  const int below = (bit - shift) / 64;
  result.exponent = below + (high != 0 ? 2 : 1);
  result.words[Words - 1] = high != 0 ? high : low;
  result.words[Words - 2] = high != 0 ? low : 0;
  result.negative = negative;
  return result;
}

/// Drops zero words from the top. The error, in units of the last word, is then of so many smaller units.
template <std::size_t Words>
void normalise(Multiword<Words>& x) {
  if (x.top() != 0) {
    return;
  }
  std::size_t zeros = 1;
  while (zeros < Words && x.words[Words - 1 - zeros] == 0) {
    ++zeros;
  }
  if (zeros == Words) {
    x.negative = false;
    x.exponent = x.error == 0 ? 0 : x.exponent;
    return;
  }
  for (std::size_t i = Words; i-- > 0;) {
    x.words[i] = i >= zeros ? x.words[i - zeros] : 0;
  }
  x.exponent -= static_cast<int>(zeros);
  if (x.error != 0) {
    x.error = std::ldexp(x.error, static_cast<int>(64 * zeros));
  }
}

/// Takes in a carry of the top word.
template <std::size_t Words>
void push_carry(Multiword<Words>& x, std::uint64_t carry) {
  using Bound = typename Multiword<Words>::Bound;
  const bool cut = x.words[0] != 0;
  for (std::size_t i = 0; i + 1 < Words; ++i) {
    x.words[i] = x.words[i + 1];
  }
  x.words[Words - 1] = carry;
  ++x.exponent;
  if (x.error != 0 || cut) {
    x.error = grown(x.error * Bound{0x1p-64} + (cut ? 1 : 0));
  }
}

/// The two's complement of all words: 2^(64 Words) - x.
template <std::size_t Words>
void complement(std::array<std::uint64_t, Words>& words) {
  std::uint64_t carry = 1;
  for (std::uint64_t& word : words) {
    word = ~word + carry;
    carry = carry != 0 && word == 0 ? 1 : 0;
  }
}

/// x + y, the sign of y being y_negative, where x has the larger exponent.
template <std::size_t Words>
Multiword<Words> ordered_sum(const Multiword<Words>& x, const Multiword<Words>& y,
                             bool y_negative) {
  using Bound = typename Multiword<Words>::Bound;
  const auto shift = static_cast<std::size_t>(x.exponent - y.exponent);
  Multiword<Words> result;
  result.exponent = x.exponent;
  result.negative = x.negative;
  // y's words where x's are: the first `shift` of `wide` are cut off, zeros follow the others
  std::array<std::uint64_t, 2 * Words> wide{};
  for (std::size_t i = 0; i < Words; ++i) {
    wide[i] = y.words[i];
  }
  const std::uint64_t* aligned = wide.data() + std::min(shift, Words);
  bool cut = false;
  if (shift != 0) {
    std::uint64_t bits = 0;
    for (const std::uint64_t* word = wide.data(); word < aligned; ++word) {
      bits |= *word;
    }
    cut = bits != 0;
  }
  if (x.error != 0 || y.error != 0 || cut) {
    const Bound of_y = shift == 0 ? y.error : y.error * words_down<Bound>(shift);
    result.error = grown(x.error + of_y + (cut ? 1 : 0));
  }
  std::uint64_t carry = 0;
  if (x.negative == y_negative) {
    for (std::size_t i = 0; i < Words; ++i) {
      const Wide wide_sum = Wide{x.words[i]} + aligned[i] + carry;
      result.words[i] = static_cast<std::uint64_t>(wide_sum);
      carry = static_cast<std::uint64_t>(wide_sum >> 64U);
    }
    if (carry != 0) {
      push_carry(result, carry);
    }
    return result;
  }
  for (std::size_t i = 0; i < Words; ++i) {
    const Wide difference = Wide{x.words[i]} - aligned[i] - carry;
    result.words[i] = static_cast<std::uint64_t>(difference);
    carry = static_cast<std::uint64_t>(difference >> 64U) & 1U;
  }
  if (carry != 0) {
    complement(result.words);
    result.negative = y_negative;
  }
  normalise(result);
  return result;
}

/// x + y, the sign of y being y_negative: errors add, and bits below the last word of the larger one are cut off, less
/// than a unit of it.
template <std::size_t Words>
Multiword<Words> sum(const Multiword<Words>& x, const Multiword<Words>& y, bool y_negative) {
  if (y.is_exact_zero()) {
    return x;
  }
  if (x.is_exact_zero()) {
    Multiword<Words> result = y;
    result.negative = y_negative;
    return result;
  }
  if (x.exponent >= y.exponent) {
    return ordered_sum(x, y, y_negative);
  }
  Multiword<Words> larger = y;
  larger.negative = y_negative;
  return ordered_sum(larger, x, x.negative);
}

template <std::size_t Words>
Multiword<Words> operator+(const Multiword<Words>& x, const Multiword<Words>& y) {
  return sum(x, y, y.negative);
}
template <std::size_t Words>
Multiword<Words> operator-(const Multiword<Words>& x, const Multiword<Words>& y) {
  return sum(x, y, !y.negative);
}

/// |x y - stored| <= |x'| ey + |y'| ex + ex ey for stored x', y' and their errors, and a unit for the bits cut off.
template <std::size_t Words>
Multiword<Words> operator*(const Multiword<Words>& x, const Multiword<Words>& y) {
  using Bound = typename Multiword<Words>::Bound;
  Multiword<Words> result;
  if (x.is_exact_zero() || y.is_exact_zero()) {
    return result;
  }
  std::array<std::uint64_t, 2 * Words> product{};
  for (std::size_t i = 0; i < Words; ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < Words; ++j) {
      // at most (2^64-1)^2 + 2 (2^64-1) = 2^128 - 1
      const Wide wide = Wide{x.words[i]} * y.words[j] + product[i + j] + carry;
      product[i + j] = static_cast<std::uint64_t>(wide);
      carry = static_cast<std::uint64_t>(wide >> 64U);
    }
    product[i + Words] = carry;
  }
  const bool is_short = product[2 * Words - 1] == 0;
  const std::size_t from = is_short ? Words - 1 : Words;
  std::uint64_t cut = 0;
  for (std::size_t i = 0; i < from; ++i) {
    cut |= product[i];
  }
  for (std::size_t i = 0; i < Words; ++i) {
    result.words[i] = product[i + from];
  }
  result.exponent = x.exponent + y.exponent - (is_short ? 1 : 0);
  result.negative = x.negative != y.negative;
  if (x.error != 0 || y.error != 0 || cut != 0) {
    const Bound carried = size_above(x) * y.error + size_above(y) * x.error +
                          x.error * (y.error * words_down<Bound>(Words));
    result.error = grown(carried * (is_short ? Bound{0x1p64} : Bound{1}) + (cut != 0 ? 1 : 0));
  }
  return result;
}

/// x times a whole number.
template <std::size_t Words>
Multiword<Words> times(const Multiword<Words>& x, std::int64_t factor) {
  using Bound = typename Multiword<Words>::Bound;
  if (factor == 0) {
    return {};
  }
  Multiword<Words> result = x;
  result.negative = x.negative != (factor < 0);
  const std::uint64_t size =
      factor < 0 ? -static_cast<std::uint64_t>(factor) : static_cast<std::uint64_t>(factor);
  if (size == 1) {
    return result;
  }
  std::uint64_t carry = 0;
  for (std::uint64_t& word : result.words) {
    const Wide wide = Wide{word} * size + carry;
    word = static_cast<std::uint64_t>(wide);
    carry = static_cast<std::uint64_t>(wide >> 64U);
  }
  if (x.error != 0) {
    result.error = grown(x.error * static_cast<Bound>(size));
  }
  if (carry != 0) {
    push_carry(result, carry);
  }
  return result;
}

}  // namespace magicmass
