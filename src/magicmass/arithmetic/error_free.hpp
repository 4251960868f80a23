// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/fused.hpp"
#include "magicmass/arithmetic/ieee.hpp"
#include "magicmass/arithmetic/lanes.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// The unevaluated sum high + low of two T, T being double or Lanes.
template <class T>
struct Sum {
  T high;
  T low;
};

/// x + y = high + low exactly (Knuth, The Art of Computer Programming, volume 2, 4.2.2).
template <class T>
[[gnu::always_inline]] inline Sum<T> two_sum(T x, T y) {
  const T sum = x + y;
  const T of_y = sum - x;
  return {sum, (x - (sum - of_y)) + (y - of_y)};
}

/// x - y = high + low exactly.
template <class T>
[[gnu::always_inline]] inline Sum<T> two_difference(T x, T y) {
  const T difference = x - y;
  const T of_y = x - difference;
  return {difference, (x - (difference + of_y)) + (of_y - y)};
}

/// x + y where |x| >= |y| or x = 0 (Dekker 1971).
template <class T>
[[gnu::always_inline]] inline Sum<T> ordered_sum(T x, T y) {
  const T sum = x + y;
  return {sum, y - (sum - x)};
}

/// x - y where |x| >= |y|.
template <class T>
[[gnu::always_inline]] inline Sum<T> ordered_difference(T x, T y) {
  const T difference = x - y;
  return {difference, (x - difference) - y};
}

#ifndef __FMA__
/// x = high + low with at most 26 bits each (Veltkamp), |x| < 2^996.
template <class T>
[[gnu::always_inline]] inline Sum<T> halves(T x) {
  const T spread = x * T(0x1p27 + 1);
  const T high = spread - (spread - x);
  return {high, x - high};
}
/// The same with at most 26 and 27 bits, of one sign: half the operations for vectors.
template <class T>
[[gnu::always_inline]] inline Sum<T> cut_off(T x) {
  if constexpr (lane_count<T> == 1) {
    return halves(x);
  } else {
    const T high = leading<26>(x);
    return {high, x - high};
  }
}
/// The error of a product whose factors' low halves have 53 bits together at most.
template <class T>
[[gnu::always_inline]] inline T product_error_of_halves(Sum<T> x, Sum<T> y, T product) {
  return x.low * y.low - (((product - x.high * y.high) - x.low * y.high) - x.high * y.low);
}
#endif

/// x y - z for z = x y rounded: the error of that rounding. It is a double where |x y| >= 2^-968 or so, so a fused
/// instruction and Dekker's product give the same bits.
template <class T>
[[gnu::always_inline]] inline T product_error(T x, T y, T product) {
#ifdef __FMA__
  return fused_difference(x, y, product);
#else
  // y cut off after 26 bits does as well, as the other 27 meet 26 at most
  return product_error_of_halves(halves(x), cut_off(y), product);
#endif
}

/// The same for a whole number y. Where all lanes' are below 2^26 they need not be halved.
template <class T>
[[gnu::always_inline]] inline T product_error_by_whole(T x, T y, T product) {
#ifndef __FMA__
  if (all(y < T(0x1p26))) {
    const Sum<T> a = cut_off(x);
    return a.low * y - (product - a.high * y);
  }
#endif
  return product_error(x, y, product);
}

/// x y = high + low exactly.
template <class T>
[[gnu::always_inline]] inline Sum<T> two_product(T x, T y) {
  const T product = x * y;
  return {product, product_error(x, y, product)};
}

/// z + x y and z - x y for a product that is a double: fused or not, the same bits.
template <class T>
[[gnu::always_inline]] inline T plus_exact(T z, T x, T y) {
#ifdef __FMA__
  return fused_sum(x, y, z);
#else
  return z + x * y;
#endif
}
template <class T>
[[gnu::always_inline]] inline T less_exact(T z, T x, T y) {
#ifdef __FMA__
  return fused_remainder(z, x, y);
#else
  return z - x * y;
#endif
}

/// z - x y rounded once, where x y is from z/2 to 2 z: z less the rounded product is exact (Sterbenz).
template <class T>
[[gnu::always_inline]] inline T less_product(T z, T x, T y) {
#ifdef __FMA__
  return fused_remainder(z, x, y);
#else
  const Sum<T> product = two_product(x, y);
  return (z - product.high) - product.low;
#endif
}
/// 1 - x y rounded once, where |x y - 1| <= 2^-20.
template <class T>
[[gnu::always_inline]] inline T one_minus_product(T x, T y) {
  return less_product(T(1.0), x, y);
}
/// The same for y of 48 bits at most, the square of a single-precision number.
template <class T>
[[gnu::always_inline]] inline T one_minus_product_by_short(T x, T y) {
#ifdef __FMA__
  return fused_remainder(T(1.0), x, y);
#else
  const T product = x * y;
  return (T(1.0) - product) - product_error_of_halves(cut_off(x), cut_off(y), product);
#endif
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
