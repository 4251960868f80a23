// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "magicmass/evaluators/multiword.hpp"
#include "magicmass/evaluators/multiword_division.hpp"

namespace magicmass {

/// A finite double, exactly.
template <std::size_t Words>
Multiword<Words> from_double(double value) {
  constexpr std::uint64_t hidden = std::uint64_t{1} << 52U;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<int>((bits >> 52U) & 0x7ffU);
  const std::uint64_t fraction = bits & (hidden - 1);
  return multiword<Words>(biased == 0 ? fraction : fraction | hidden,
                          (biased == 0 ? 1 : biased) - 1075, (bits >> 63U) != 0);
}

/// A double near the number: within 2^-50 relative, or an infinity or 0 beyond its range. A hint, no bound.
template <std::size_t Words>
double hint(const Multiword<Words>& x) {
  const double leading = std::ldexp(static_cast<double>(x.words[Words - 2]), -64);
  const double size = std::ldexp(static_cast<double>(x.top()) + leading, 64 * (x.exponent - 1));
  return x.negative ? -size : size;
}

/// A real number as an integer and a rest known to within a bound, at most 1/2 in size; numbers past 2^30 are all rest.
/// The cosines of a long run of collisions are 1 less something as small as alpha, and a product
///
///     (k + f)(l + g) = k l + (k g + l f + f g)
///
/// keeps the relative precision of that small part: a few words are enough however small alpha is.
template <std::size_t Words>
struct NearInteger {
  std::int64_t whole = 0;
  Multiword<Words> rest{};

  NearInteger() = default;
  template <std::integral Whole>
  explicit NearInteger(Whole value)
      : NearInteger(0, multiword<Words>(value < 0 ? -static_cast<std::uint64_t>(value)
                                                  : static_cast<std::uint64_t>(value),
                                        0, value < 0)) {}
  explicit NearInteger(double value) : NearInteger(0, from_double<Words>(value)) {}
  NearInteger(std::int64_t integer, const Multiword<Words>& more) : whole(integer), rest(more) {
    settle();
  }

  /// The whole number in one.
  Multiword<Words> together() const { return whole == 0 ? rest : magnitude(whole) + rest; }

  /// +1 or -1 where the true number certainly has that sign, else 0.
  int certain_sign() const {
    const Multiword<Words> all = together();
    // false also where the error is NaN
    using Bound = typename Multiword<Words>::Bound;
    const bool certain = all.error * words_down<Bound>(Words) < size_below(all);
    return certain ? (all.negative ? -1 : 1) : 0;
  }

private:
  static constexpr std::int64_t largest_whole = std::int64_t{1} << 30U;

  static Multiword<Words> magnitude(std::int64_t value) {
    return multiword<Words>(
        value < 0 ? -static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value), 0,
        value < 0);
  }

  /// Moves what is 1/2 or more of the rest into the integer, or, where that gets too large, all of it into the rest.
  void settle() {
    if (rest.exponent == 1 && rest.top() < largest_whole) {
      const auto integer = static_cast<std::int64_t>(rest.top());
      whole += rest.negative ? -integer : integer;
      rest.words[Words - 1] = 0;
      normalise(rest);
    }
    if (rest.exponent == 0 && (rest.top() >> 63U) != 0) {
      whole += rest.negative ? -1 : 1;
      complement(rest.words);
      rest.negative = !rest.negative;
      normalise(rest);
    }
    const bool rest_is_large = rest.exponent > 0 && rest.top() != 0;
    if (whole != 0 && (rest_is_large || whole > largest_whole || whole < -largest_whole)) {
      rest = together();
      whole = 0;
    }
  }
};

template <std::size_t Words>
NearInteger<Words> operator+(const NearInteger<Words>& x, const NearInteger<Words>& y) {
  return {x.whole + y.whole, x.rest + y.rest};
}
template <std::size_t Words>
NearInteger<Words> operator-(const NearInteger<Words>& x, const NearInteger<Words>& y) {
  return {x.whole - y.whole, x.rest - y.rest};
}
template <std::size_t Words>
NearInteger<Words> operator-(const NearInteger<Words>& x) {
  return NearInteger<Words>() - x;
}
template <std::size_t Words>
NearInteger<Words> operator*(const NearInteger<Words>& x, const NearInteger<Words>& y) {
  return {x.whole * y.whole, x.rest * y.rest + (times(y.rest, x.whole) + times(x.rest, y.whole))};
}

/// With q the integer near x/y: q + (x - q y)/y, so that a quotient near an integer keeps its precision, too.
template <std::size_t Words>
NearInteger<Words> operator/(const NearInteger<Words>& x, const NearInteger<Words>& y) {
  const Multiword<Words> divisor = y.together();
  const double quotient = std::nearbyint(hint(x.together()) / hint(divisor));
  constexpr double largest = 0x1p30;
  if (!(std::fabs(quotient) >= 1.0 && std::fabs(quotient) < largest)) {
    return {0, x.together() / divisor};
  }
  const auto integer = static_cast<std::int64_t>(quotient);
  const NearInteger<Words> multiple(integer * y.whole, times(y.rest, integer));
  return {integer, (x - multiple).together() / divisor};
}

}  // namespace magicmass
