// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "magicmass/evaluators/multiword.hpp"

namespace magicmass {

/// One word of a quotient, and a partial remainder `rest` of Words + 1 words less that times the divisor: at first
/// the word that the three leading words of rest and two of the divisor suggest, at most one too large, which the
/// borrow of the subtraction shows (Knuth, The Art of Computer Programming 2, 4.3.1, algorithm D). The divisor's top
/// bit is set, and rest < divisor 2^64.
template <std::size_t Words>
std::uint64_t quotient_word(std::uint64_t* rest, const std::array<std::uint64_t, Words>& divisor) {
  constexpr std::uint64_t all_ones = ~std::uint64_t{0};
  const std::uint64_t high = divisor[Words - 1];
  std::uint64_t word = all_ones;
  Wide left =
      Wide{rest[Words - 1]} + high;  // what is left of two words, where the guess is 2^64 - 1
  if (rest[Words] < high) {
    const Wide two = (Wide{rest[Words]} << 64U) | rest[Words - 1];
    word = static_cast<std::uint64_t>(two / high);
    left = two - Wide{word} * high;
  }
  while (left <= all_ones && Wide{word} * divisor[Words - 2] > ((left << 64U) | rest[Words - 2])) {
    --word;
    left += high;
  }
  std::uint64_t carry = 0;
  std::uint64_t borrow = 0;
  for (std::size_t i = 0; i < Words; ++i) {
    const Wide product = Wide{word} * divisor[i] + carry;
    carry = static_cast<std::uint64_t>(product >> 64U);
    const Wide difference = Wide{rest[i]} - static_cast<std::uint64_t>(product) - borrow;
    rest[i] = static_cast<std::uint64_t>(difference);
    borrow = static_cast<std::uint64_t>(difference >> 64U) & 1U;
  }
  const Wide difference = Wide{rest[Words]} - carry - borrow;
  rest[Words] = static_cast<std::uint64_t>(difference);
  if ((difference >> 64U) != 0) {
    --word;
    carry = 0;
    for (std::size_t i = 0; i < Words; ++i) {
      const Wide total = Wide{rest[i]} + divisor[i] + carry;
      rest[i] = static_cast<std::uint64_t>(total);
      carry = static_cast<std::uint64_t>(total >> 64U);
    }
    rest[Words] += carry;
  }
  return word;
}

/// x / y by long division, word by word, cut off after Words words. With q = x/y for the stored x, y and their errors
/// ex, ey: |(x +- ex)/(y +- ey) - q| <= (ex + |q| ey)/(|y| - ey). Nothing is certain about a quotient by what may be 0.
template <std::size_t Words>
Multiword<Words> operator/(const Multiword<Words>& x, const Multiword<Words>& y) {
  using Bound = typename Multiword<Words>::Bound;
  Multiword<Words> result;
  const Bound divisor_below = size_below(y) - y.error * words_down<Bound>(Words);
  if (!(divisor_below > 0)) {
    result.error = std::numeric_limits<Bound>::infinity();
    return result;
  }
  if (x.is_exact_zero()) {
    return result;
  }
  const auto shift = static_cast<unsigned>(std::countl_zero(y.top()));
  const auto shifted = [shift](std::uint64_t word, std::uint64_t below) {
    return shift == 0 ? word : (word << shift) | (below >> (64U - shift));
  };
  typename Multiword<Words>::Magnitude divisor{};
  std::array<std::uint64_t, 2 * Words + 1> rest{};
  for (std::size_t i = 0; i < Words; ++i) {
    divisor[i] = shifted(y.words[i], i > 0 ? y.words[i - 1] : 0);
    rest[i + Words] = shifted(x.words[i], i > 0 ? x.words[i - 1] : 0);
  }
  rest[2 * Words] = shifted(0, x.top());
  std::array<std::uint64_t, Words + 1> quotient{};
  for (std::size_t i = Words + 1; i-- > 0;) {
    quotient[i] = quotient_word(rest.data() + i, divisor);
  }
  bool cut = false;
  for (std::size_t i = 0; i < Words; ++i) {
    cut = cut || rest[i] != 0;
  }
  const bool is_long = quotient[Words] != 0;
  cut = cut || (is_long && quotient[0] != 0);
  for (std::size_t i = 0; i < Words; ++i) {
    result.words[i] = quotient[i + (is_long ? 1 : 0)];
  }
  result.exponent = x.exponent - y.exponent + (is_long ? 1 : 0);
  result.negative = x.negative != y.negative;
  if (x.error != 0 || y.error != 0 || cut) {
    const Bound carried =
        x.error * (is_long ? Bound{0x1p-64} : Bound{1}) + size_above(result) * y.error;
    result.error = grown(carried / divisor_below + (cut ? 1 : 0));
  }
  return result;
}

/// x over a whole number below 2^32.
template <std::size_t Words>
Multiword<Words> over(const Multiword<Words>& x, std::uint32_t divisor) {
  Multiword<Words> result = x;
  std::uint64_t rest = 0;
  for (std::size_t i = Words; i-- > 0;) {
    const std::uint64_t high = (rest << 32U) | (x.words[i] >> 32U);
    const std::uint64_t low = ((high % divisor) << 32U) | (x.words[i] & 0xffffffffU);
    result.words[i] = ((high / divisor) << 32U) | (low / divisor);
    rest = low % divisor;
  }
  const bool cut = rest != 0;
  if (x.error != 0 || cut) {
    result.error =
        grown(x.error / static_cast<typename Multiword<Words>::Bound>(divisor) + (cut ? 1 : 0));
  }
  normalise(result);
  return result;
}

}  // namespace magicmass
