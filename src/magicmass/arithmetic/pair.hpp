// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/error_free.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A real number as the unevaluated sum of two T (double or Lanes): the number type of tier `fast`. With u = 2^-53,
/// products and quotients are within 2^-100 of themselves and sums within 2^-103 (|x| + |y|), as long as no
/// product is below 2^-968 or beyond 2^996; arctangent, sine and cosine are good to u/4. So
/// a result is hardly worse than rounded once.
template <class T>
struct Pair {
  using Real = T;
  using ArcTangent = Pair;

  T high;
  T low;

  Pair() = default;
  explicit Pair(T exact) : high(exact), low(0.0) {}
  Pair(T high_part, T low_part) : high(high_part), low(low_part) {}

  /// x + y and x y of doubles, exactly.
  static Pair sum(T x, T y) {
    const Sum<T> s = two_sum(x, y);
    return {s.high, s.low};
  }
  static Pair product(T x, T y) {
    const Sum<T> p = two_product(x, y);
    return {p.high, p.low};
  }
  static Pair pi() { return {T(0x1.921fb54442d18p+1), T(0x1.1a62633145c07p-53)}; }

  friend Pair operator-(Pair x) { return {-x.high, -x.low}; }
  friend Pair operator+(Pair x, Pair y) {
    const Sum<T> s = two_sum(x.high, y.high);
    return {s.high, s.low + (x.low + y.low)};
  }
  friend Pair operator-(Pair x, Pair y) {
    const Sum<T> s = two_difference(x.high, y.high);
    return {s.high, s.low + (x.low - y.low)};
  }
  friend Pair operator+(Pair x, T y) {
    const Sum<T> s = two_sum(x.high, y);
    return {s.high, s.low + x.low};
  }
  friend Pair operator*(Pair x, Pair y) {
    const Sum<T> p = two_product(x.high, y.high);
    return {p.high, p.low + (x.high * y.low + x.low * y.high)};
  }
  friend Pair operator*(Pair x, T y) {
    const Sum<T> p = two_product(x.high, y);
    return {p.high, p.low + x.low * y};
  }
  friend Pair operator/(Pair x, Pair y) {
    const T inverse = T(1.0) / y.high;
    const T quotient = x.high * inverse;
    const T rest = less_product(x.high, quotient, y.high) + (x.low - quotient * y.low);
    return normalised(Pair{quotient, rest * inverse});
  }
  /// The same number, low at most half an ulp of high. Needs |high| >= |low|.
  friend Pair normalised(Pair x) {
    const Sum<T> s = ordered_sum(x.high, x.low);
    return {s.high, s.low};
  }
  /// x 2^k, exactly, given 2^k.
  friend Pair scaled(Pair x, double power_of_two) {
    return {x.high * T(power_of_two), x.low * T(power_of_two)};
  }
  template <class Condition>
  friend Pair select(Condition condition, Pair yes, Pair no) {
    return {select(condition, yes.high, no.high), select(condition, yes.low, no.low)};
  }
  /// The nearest T, but for ties and near-ties.
  friend T rounded(Pair x) { return x.high + x.low; }
};

/// 1/y within 2^-100.
template <class T>
[[gnu::always_inline]] inline Pair<T> reciprocal(Pair<T> y) {
  return Pair<T>(T(1.0)) / y;
}

/// 1/sqrt(w), for w from 2^-120 to 2^120 in lanes, within 2^-66, and any w > 0 of a single double, within 2^-100.
template <class T>
[[gnu::always_inline]] inline Pair<T> reciprocal_square_root(Pair<T> w) {
  if constexpr (lane_count<T> == 1) {
    // no square of the root may overflow or underflow: a power of 4 moves w, exactly
    double shift = 1.0;
    if (!(w.high >= 0x1p-900 && w.high <= 0x1p900)) [[unlikely]] {
      shift = w.high < 1.0 ? 0x1p256 : 0x1p-256;
      w = scaled(w, shift * shift);
    }
    // one Newton step from the rounded root: its square's error and that of w count
    const double y = 1.0 / square_root(w.high);
    const Sum<T> square = two_product(y, y);
    const double e =
        one_minus_product(w.high, square.high) - (w.high * square.low + w.low * square.high);
    return {y * shift, 0.5 * y * e * shift};
  } else {
    // y has 24 bits, so y^2 has 48 and e is within 2^-74; what is left out of the series of (1 - e)^(-1/2), which
    // begins 1 + e/2 + 3/8 e^2, is 5/16 e^3 < 2^-66.
    const T y = reciprocal_square_root_estimate(w.high);
    const T square = y * y;
    const T e = one_minus_product_by_short(w.high, square) - w.low * square;
    const Sum<T> root = ordered_sum(y, y * (e * (T(0.5) + T(0.375) * e)));
    return {root.high, root.low};
  }
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
