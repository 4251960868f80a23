// SPDX-License-Identifier: MIT
// std::numbers::pi_v for numbers of up to 24 words, computed by the compiler.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "magicmass/evaluators/near_integer.hpp"

namespace magicmass {

/// Words of a number in [0, 2^64): the integer part first, then the fraction.
template <std::size_t Words>
using PlainFixed = std::array<std::uint64_t, Words>;

/// x / divisor, rounded down; the words before `from` are 0.
template <std::size_t Words>
constexpr PlainFixed<Words> over(PlainFixed<Words> x, std::uint64_t divisor, std::size_t from) {
  Wide rest = 0;
  for (std::size_t i = from; i < Words; ++i) {
    const Wide two = (rest << 64U) | x[i];
    x[i] = static_cast<std::uint64_t>(two / divisor);
    rest = two % divisor;
  }
  return x;
}

/// sum + x, or sum - x.
template <std::size_t Words>
constexpr void accumulate(PlainFixed<Words>& sum, const PlainFixed<Words>& x, bool subtract) {
  std::uint64_t carry = subtract ? 1 : 0;
  for (std::size_t i = Words; i-- > 0;) {
    const Wide total = Wide{sum[i]} + (subtract ? ~x[i] : x[i]) + carry;
    sum[i] = static_cast<std::uint64_t>(total);
    carry = static_cast<std::uint64_t>(total >> 64U);
  }
}

/// sum +- factor atan(1/n), by the series of the arctangent up to its last term that is not 0. A term is within 3 units
/// of the last place: each of the divisions by n^2 and that by 2i+1 costs less than one, and the earlier ones fade.
template <std::size_t Words>
constexpr void add_arctangent(PlainFixed<Words>& sum, std::uint64_t factor, std::uint64_t n,
                              bool subtract) {
  PlainFixed<Words> power{factor};
  power = over(power, n, 0);
  std::size_t from = 0;
  for (std::uint64_t i = 1;; i += 2) {
    while (from < Words && power[from] == 0) {
      ++from;
    }
    if (from == Words) {
      return;
    }
    accumulate(sum, over(power, i, from), subtract);
    subtract = !subtract;
    power = over(power, n * n, from);
  }
}

/// pi = 16 atan(1/5) - 4 atan(1/239) (Machin), in 24 words after the point and one to hold the errors: not 500 terms,
/// so less than 2^11 of its units.
inline constexpr std::size_t most_words_of_pi = 24;
inline constexpr auto words_of_pi = [] {
  PlainFixed<most_words_of_pi + 2> pi{};
  add_arctangent(pi, 16, 5, false);
  add_arctangent(pi, 4, 239, true);
  return pi;
}();

/// pi, within 2 units of the last place: one for what is cut off, and far less for the error of words_of_pi.
template <std::size_t Words>
constexpr NearInteger<Words> pi_in_words() {
  static_assert(Words <= most_words_of_pi);
  NearInteger<Words> pi;
  pi.whole = static_cast<std::int64_t>(words_of_pi[0]);
  for (std::size_t i = 0; i < Words; ++i) {
    pi.rest.words[Words - 1 - i] = words_of_pi[1 + i];
  }
  pi.rest.error = 2;
  return pi;
}

}  // namespace magicmass

namespace std::numbers {
template <size_t Words>
inline constexpr magicmass::NearInteger<Words> pi_v<magicmass::NearInteger<Words>> =
    magicmass::pi_in_words<Words>();
}  // namespace std::numbers
