// SPDX-License-Identifier: MIT
// DoubleDouble: an unevaluated sum of two T, and its operations. What each loses, and how large a
// low part it leaves, is in symbolic/codegen/operations.cpp; names of algorithms as in Joldes,
// Muller, Popescu, ACM TOMS 44 (2017), 15res.
#pragma once

#include "magicmass/arithmetic/simd.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {
template <class T>
struct DoubleDouble;
template <class T>
DoubleDouble<T> two_sum(T x, T y);
template <class T>
DoubleDouble<T> fast_two_sum(T x, T y);
/// high + low. Low parts are small against high parts, but may be some ulps of them. The static
/// functions are what generated code asks of any number type.
template <class T>
struct DoubleDouble {
  using Value = T;   // of inputs, counts and error bounds
  using Result = T;  // of rounded outputs
  static constexpr bool is_wide = false;
  T high, low;

  [[gnu::always_inline]] static T all(double x) { return arithmetic::all<T>(x); }
  [[gnu::always_inline]] static T whole(std::int64_t n) { return all(double(n)); }
  [[gnu::always_inline]] static std::int64_t to_whole(T n) { return arithmetic::to_whole(n); }
  [[gnu::always_inline]] static T to_result(T x) { return x; }
  /// 1 for an even whole number, -1 for an odd one.
  [[gnu::always_inline]] static T turn(T n) {
    return 1.0 - 2.0 * magnitude(n - 2.0 * arithmetic::nearest(0.5 * n));
  }
  [[gnu::always_inline]] static T nearest(T x) { return arithmetic::nearest(x); }
  [[gnu::always_inline]] static T magnitude_of(T x) { return magnitude(x); }
  [[gnu::always_inline]] static T times_sign_of(T x, T y) {
    return arithmetic::times_sign_of(x, y);
  }
  [[gnu::always_inline]] static DoubleDouble exact(T x) { return {x, T{}}; }
  [[gnu::always_inline]] static DoubleDouble two_sum(T x, T y) { return arithmetic::two_sum(x, y); }
  [[gnu::always_inline]] static DoubleDouble fast_two_sum(T x, T y) {
    return arithmetic::fast_two_sum(x, y);
  }
  /// p/q, or pi p/q: to its nearest double and that of the rest.
  [[gnu::always_inline]] static DoubleDouble rational(double, double, double high, double low) {
    return {all(high), all(low)};
  }
  [[gnu::always_inline]] static DoubleDouble pi_times(double, double, double high, double low) {
    return {all(high), all(low)};
  }
};

/// x + y exactly.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> two_sum(T x, T y) {
  const T sum = x + y;
  const T of_y = sum - x;
  return {sum, (x - (sum - of_y)) + (y - of_y)};
}
/// x + y exactly, where |x| >= |y| or x = 0 or the sum is exact; else y's rounding is lost.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> fast_two_sum(T x, T y) {
  const T sum = x + y;
  return {sum, y - (sum - x)};
}
/// x as a sum of two numbers of 26 bits; |x| <= 2^996.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> veltkamp_split(T x) {
  const T scaled = x * 0x1.0000002p27;
  const T high = scaled - (scaled - x);
  return {high, x - high};
}
/// x y exactly, where 2^-960 <= |x y| <= 2^1000 or x y = 0, |x|, |y| <= 2^990.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> two_product(T x, T y) {
  const T product = x * y;
  if constexpr (has_fma) {
    return {product, fused(x, y, -product)};
  } else {  // Dekker's
    const DoubleDouble<T> a = veltkamp_split(x);
    const DoubleDouble<T> b = veltkamp_split(y);
    const T rest = ((a.high * b.high - product) + a.high * b.low) + a.low * b.high;
    return {product, rest + a.low * b.low};
  }
}
/// z - x y, rounded once, where x y is from z/2 to 2 z: fused or not, the same bits.
template <class T>
[[gnu::always_inline]] inline T less_product(T z, T x, T y) {
  if constexpr (has_fma) {
    return fused(-x, y, z);
  } else {
    const DoubleDouble<T> product = two_product(x, y);
    return (z - product.high) - product.low;
  }
}

template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> operator-(DoubleDouble<T> x) {
  return {-x.high, -x.low};
}
/// x + y of one sign. SloppyDWPlusDW without its last step.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> operator+(DoubleDouble<T> x, DoubleDouble<T> y) {
  const DoubleDouble<T> sum = two_sum(x.high, y.high);
  return {sum.high, sum.low + (x.low + y.low)};
}
/// x + y of any signs. SloppyDWPlusDW.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> cancelling_sum(DoubleDouble<T> x, DoubleDouble<T> y) {
  const DoubleDouble<T> sum = x + y;
  return fast_two_sum(sum.high, sum.low);
}
/// x + y where -y is from x/2 to 2 x, so that the high parts' sum is exact.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> near_sum(DoubleDouble<T> x, DoubleDouble<T> y) {
  return fast_two_sum(x.high + y.high, x.low + y.low);
}
/// x y. DWTimesDW3 without its last step.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> operator*(DoubleDouble<T> x, DoubleDouble<T> y) {
  const DoubleDouble<T> product = two_product(x.high, y.high);
  return {product.high, fused(x.high, y.low, fused(x.low, y.high, product.low))};
}
/// x y, y exact. DWTimesFP3 without its last step.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> times(DoubleDouble<T> x, T y) {
  const DoubleDouble<T> product = two_product(x.high, y);
  return {product.high, fused(x.low, y, product.low)};
}
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> scaled(DoubleDouble<T> x, double power_of_2) {
  return {x.high * power_of_2, x.low * power_of_2};
}
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> magnitude(DoubleDouble<T> x) {
  return {magnitude(x.high), times_sign_of(x.low, x.high)};
}
template <class T>
[[gnu::always_inline]] inline T leading(DoubleDouble<T> x) {
  return x.high;
}
template <class T>
[[gnu::always_inline]] inline T rounded(DoubleDouble<T> x) {
  return x.high + x.low;
}

/// x/y: one step of Newton's from the rounded quotient.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> quotient(T x, DoubleDouble<T> y) {
  const T inverse = 1.0 / y.high;
  const T q = x * inverse;
  return {q, (less_product(x, q, y.high) - q * y.low) * inverse};
}
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> quotient(DoubleDouble<T> x, DoubleDouble<T> y) {
  const T inverse = 1.0 / y.high;
  const T q = x.high * inverse;
  const T rest = (less_product(x.high, q, y.high) + x.low) - q * y.low;
  return {q, rest * inverse};
}
/// 1/sqrt(y): one step of Newton's from the rounded one.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> reciprocal_root(DoubleDouble<T> y) {
  const T root = square_root(y.high) * (1.0 / y.high);
  const DoubleDouble<T> one = two_product(root, y.high);
  const T of_low = root * fused(y.low, root, one.low);
  return {root, (0.5 * root) * (less_product(all<T>(1.0), one.high, root) - of_low)};
}
}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
