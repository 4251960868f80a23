// SPDX-License-Identifier: MIT
// Ziv's rounding test, and tests of signs and ranges: what is not certain leaves a doubt, which is
// not 0 (a NaN is none either), and the caller turns to a more precise number.
#pragma once

#include "magicmass/arithmetic/double_double.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {
template <class T>
struct Rounded {
  T value, doubt;
};
/// p, rounded; doubt is 0 where all numbers within `error` of p round alike. The two roundings of
/// p.low +- error are part of `error`.
template <class T>
[[gnu::always_inline]] inline Rounded<T> rounding_test(DoubleDouble<T> p, T error) {
  const T top = p.high + (p.low + error);
  return {top, top - (p.high + (p.low - error))};
}
/// |x|, of its leading part: error bounds are multiples of such.
template <class N>
[[gnu::always_inline]] inline auto size_of(const N& x) {
  return N::magnitude_of(leading(x));
}
/// p, rounded. Tiers that are tested add what is in doubt.
template <class Tier, class N, class T, class R>
[[gnu::always_inline]] inline R rounded_by(const N& p, [[maybe_unused]] const T& error,
                                           [[maybe_unused]] R& doubt) {
  if constexpr (Tier::is_tested) {
    const auto tested = rounding_test(p, error);
    doubt = doubt + tested.doubt;
    return tested.value;
  } else {
    return rounded(p);
  }
}
/// 0 where x is certainly positive, 1 elsewhere: `error` bounds low part and error of x.
template <class T>
[[gnu::always_inline]] inline T doubt_of_sign(DoubleDouble<T> x, T error) {
  return select(is_above(x.high, error), T{}, all<T>(1.0));
}
/// 0 where low < x.high < high, 1 elsewhere.
template <class T>
[[gnu::always_inline]] inline T doubt_of_range(DoubleDouble<T> x, double low, double high) {
  const T half_width = all<T>(0.5 * high - 0.5 * low);
  const T distance = magnitude(x.high - (0.5 * high + 0.5 * low));
  return select(is_above(half_width, distance), T{}, all<T>(1.0));
}
}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
