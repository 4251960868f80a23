// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/pair.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A real number as a Pair together with an upper bound of |pair - number|: the number type of tier `accurate`. The bound
/// grows by more than each operation's rounding, so that `certainly_rounded` never says what is not so. Valid while
/// no product is below 2^-960 or beyond 2^996.
template <class T>
struct Bounded {
  using Real = T;
  using ArcTangent = Bounded;

  Pair<T> pair;
  T error;

  /// Bound of an operation's own rounding, relative to its operands' or its result's size. A pair product leaves out low
  /// times low (2^-104, as lows are at most 2^-52 of highs) and rounds four times at 2^-52 2^-53: 2^-102 in all. A
  /// sum rounds twice at the size of the lows: 2^-104. The bound's own roundings are a 2^-50 part of it, which the
  /// last test adds.
  static constexpr double rounding = 0x1p-100;

  Bounded() = default;
  explicit Bounded(T exact) : pair(exact), error(0.0) {}
  Bounded(Pair<T> value, T bound) : pair(value), error(bound) {}

  static Bounded sum(T x, T y) { return {Pair<T>::sum(x, y), T(0.0)}; }
  static Bounded product(T x, T y) { return {Pair<T>::product(x, y), T(0.0)}; }
  static Bounded pi() { return {Pair<T>::pi(), T(0x1p-105)}; }

  friend Bounded operator-(Bounded x) { return {-x.pair, x.error}; }
  friend Bounded operator+(Bounded x, Bounded y) {
    const Pair<T> s = x.pair + y.pair;
    return {normalised(s),
            (x.error + y.error) + T(rounding) * (magnitude(x.pair.high) + magnitude(y.pair.high))};
  }
  friend Bounded operator-(Bounded x, Bounded y) { return x + (-y); }
  friend Bounded operator+(Bounded x, T y) {
    const Pair<T> s = x.pair + y;
    return {normalised(s), x.error + T(rounding) * (magnitude(x.pair.high) + magnitude(y))};
  }
  friend Bounded operator*(Bounded x, Bounded y) {
    const Pair<T> p = normalised(x.pair * y.pair);
    return {p, (magnitude(x.pair.high) * y.error + magnitude(y.pair.high) * x.error) +
                   (T(rounding) * magnitude(p.high) + x.error * y.error)};
  }
  friend Bounded operator*(Bounded x, T y) {
    const Pair<T> p = normalised(x.pair * y);
    return {p, magnitude(y) * x.error + T(rounding) * magnitude(p.high)};
  }
  /// The divisor's error has to be below half of it; else the bound is infinite or not a number, and nothing certain.
  friend Bounded operator/(Bounded x, Bounded y) {
    const Pair<T> q = x.pair / y.pair;
    // |x/y - q| <= (ex + |q| ey)/(|y| - ey)
    const T size = magnitude(y.pair.high) - T(2.0) * y.error;
    const T bound = (x.error + magnitude(q.high) * y.error) / size;
    return {q, select(size > T(0.0), bound * T(1 + 0x1p-40), T(HUGE_VAL)) +
                   T(rounding) * magnitude(q.high)};
  }
  friend Bounded scaled(Bounded x, double power_of_two) {
    return {scaled(x.pair, power_of_two), x.error * T(std::fabs(power_of_two))};
  }
  template <class Condition>
  friend Bounded select(Condition condition, Bounded yes, Bounded no) {
    return {select(condition, yes.pair, no.pair), select(condition, yes.error, no.error)};
  }
  friend T rounded(Bounded x) { return rounded(x.pair); }
  /// Whether the nearest double of the number is certainly rounded(x): both ends of the enclosure have that one.
  friend auto certainly_rounded(Bounded x) {
    const Pair<T> y = normalised(x.pair);
    const T margin = x.error * T(1 + 0x1p-40) + T(0x1p-104) * magnitude(y.high);
    return (y.high + (y.low + margin)) == (y.high + (y.low - margin));
  }
};

template <class T>
[[gnu::always_inline]] inline Bounded<T> reciprocal(Bounded<T> y) {
  return Bounded<T>(T(1.0)) / y;
}

/// 1/sqrt(w), as for Pair.
template <class T>
inline Bounded<T> reciprocal_square_root(Bounded<T> w) {
  // Newton's step from y within 2^-67: 3/8 e^2 is below 2^-133, so 2^-100 y covers the pairs' roundings.
  const Pair<T> y = reciprocal_square_root(w.pair);
  const Pair<T> product = w.pair * (y * y);
  const T e = (T(1.0) - product.high) - product.low;
  const Pair<T> root = normalised(Pair<T>{y.high, y.low + T(0.5) * y.high * e});
  // half of the relative error of w
  return {root,
          w.error * root.high * (root.high * root.high) + T(Bounded<T>::rounding) * root.high};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
