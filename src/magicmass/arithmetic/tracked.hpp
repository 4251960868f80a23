// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/multiply_add.hpp"
#include "magicmass/arithmetic/pair.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A real number as a Pair, and `size`: |pair - number| <= degree * unit * size, where degree is the number of factors,
/// counted like that of a polynomial, that went into it. Sizes are added in sums and multiplied in products (the
/// same polynomial in the absolute values), so they cost one operation each: the number type of the first stage of tier
/// `accurate`. Each primitive makes numbers of degree 1; rounding in pairs, 2^-100 of the sizes, is far below a unit.
/// Where it fuses products and sums its bits depend on the instruction set: for results that are certainly the nearest doubles, or
/// not taken.
template <class T, bool fuses = false>
struct Tracked {
  using Real = T;
  using ArcTangent = Tracked;

  Pair<T> pair;
  T size;

  static constexpr double unit = 0x1p-70;
  static constexpr double highest_degree = 8;  ///< of any generated formula

  Tracked() = default;
  explicit Tracked(T exact) : pair(exact), size(magnitude(exact)) {}
  Tracked(Pair<T> value, T of_size) : pair(value), size(of_size) {}

  static Tracked sum(T x, T y) {
    const Pair<T> s = Pair<T>::sum(x, y);
    return {s, magnitude(s.high)};
  }
  static Tracked product(T x, T y) {
    const Pair<T> p = Pair<T>::product(x, y);
    return {p, magnitude(p.high)};
  }
  /// (2 + alpha) alpha, or (1 + alpha)^2 where `is_beyond`, which is from alpha = 1 on: within 2^-100.
  template <class Condition>
  static Tracked root_argument(T alpha, Condition is_beyond) {
    const Sum<T> s = ordered_sum(select(is_beyond, alpha, T(2.0)), smaller(alpha, T(1.0)));
    const T factor = alpha + where(is_beyond, T(1.0));  // rounded like s.high
    const Sum<T> product = two_product(s.high, factor);
    const T low = multiply_add<fuses>(s.low, factor + where(is_beyond, s.high), product.low);
    return {{product.high, low}, product.high};
  }
  static Tracked pi() { return {Pair<T>::pi(), T(4.0)}; }

  friend Tracked operator-(Tracked x) { return {-x.pair, x.size}; }
  friend Tracked operator+(Tracked x, Tracked y) { return {x.pair + y.pair, x.size + y.size}; }
  friend Tracked operator-(Tracked x, Tracked y) { return {x.pair - y.pair, x.size + y.size}; }
  /// Of nearly equal numbers what is left may be mostly the low part: it becomes the high part.
  friend Tracked operator+(Tracked x, T y) {
    const Pair<T> left = x.pair + y;
    return {Pair<T>::sum(left.high, left.low), x.size + magnitude(y)};
  }
  friend Tracked operator*(Tracked x, Tracked y) {
    const Sum<T> p = two_product(x.pair.high, y.pair.high);
    const T of_lows = multiply_add<fuses>(x.pair.low, y.pair.high, p.low);
    return {{p.high, multiply_add<fuses>(x.pair.high, y.pair.low, of_lows)}, x.size * y.size};
  }
  friend Tracked operator*(Tracked x, T y) {
    const Sum<T> p = two_product(x.pair.high, y);
    return {{p.high, multiply_add<fuses>(x.pair.low, y, p.low)}, x.size * magnitude(y)};
  }
  /// |x/y - q| <= (ex + |q| ey)/(|y| - ey), so the size is that sum over a little less than |y|; infinite where y is not known
  /// to 2^-20 of itself. Its degree is that of x and y together.
  friend Tracked operator/(Tracked x, Tracked y) {
    const Pair<T> q = x.pair / y.pair;
    const T divisor = magnitude(y.pair.high);
    const T of_quotient = (x.size + magnitude(q.high) * y.size) / (divisor * T(1 - 0x1p-18));
    return {q, select(y.size * T(highest_degree * unit) < divisor * T(0x1p-20), of_quotient,
                      T(HUGE_VAL))};
  }
  friend Tracked scaled(Tracked x, double power_of_two) {
    return {scaled(x.pair, power_of_two), x.size * T(std::fabs(power_of_two))};
  }
  template <class Condition>
  friend Tracked select(Condition condition, Tracked yes, Tracked no) {
    return {select(condition, yes.pair, no.pair), select(condition, yes.size, no.size)};
  }
  friend T rounded(Tracked x) { return rounded(x.pair); }
  /// Whether the nearest double of the number, of that degree at most, is certainly rounded(x). Where |high| < |low|, most of a
  /// sum is gone: lows are 2^-40 of their terms at most, and so of the size. Then nothing is certain, whatever this makes of the low.
  friend auto certainly_rounded(Tracked x, double degree = highest_degree) {
    const Sum<T> y = ordered_sum(x.pair.high, x.pair.low);
    const T most(degree * unit);
    return (y.high + multiply_add<fuses>(most, x.size, y.low)) ==
           (y.high + subtract_product<fuses>(y.low, most, x.size));
  }
};

template <class T, bool fuses>
[[gnu::always_inline]] inline Tracked<T, fuses> reciprocal(Tracked<T, fuses> y) {
  return Tracked<T, fuses>(T(1.0)) / y;
}

/// 1/sqrt(x) within 2^-51, for x from 2^-120 to 2^121 in lanes, any normal one of a single double.
template <class T>
[[gnu::always_inline]] inline T fast_reciprocal_square_root(T x) {
  // With e = 1 - x y^2 it is y (1 - e)^(-1/2) = y (1 + e/2 + 3/8 e^2 + 5/16 e^3 + ...). In the processor's estimate |e| is at most
  // 2^-13, so 35/128 e^4 is below 2^-53.8; in that of a float 2^-21.5, and 5/16 e^3 below 2^-66. e is rounded at 2^-53.
  if constexpr (lane_count<T> == 1) {
    return T(1.0) / square_root(x);
#ifdef __AVX512F__
  } else if constexpr (lane_count<T> == 8) {
    const T y = _mm512_rsqrt14_pd(x.v);
    const T e = fused_remainder(T(1.0), x * y, y);
    return fused_sum(y * e, fused_sum(fused_sum(T(0.3125), e, T(0.375)), e, T(0.5)), y);
#endif
  } else {
    const T y = reciprocal_square_root_estimate(x);
    const T e = T(1.0) - x * (y * y);
    return y + y * (e * (T(0.5) + T(0.375) * e));
  }
}

/// 1/sqrt(w) within 2^-98, a number of degree 1: for w without cancellation, as for Pair, and where it fuses in lanes from 2^-120 to
/// 2^121.
template <class T, bool fuses>
[[gnu::always_inline]] inline Tracked<T, fuses> reciprocal_square_root(Tracked<T, fuses> w) {
  T y;
  if constexpr (fuses)
    y = fast_reciprocal_square_root(w.pair.high);
  else
    y = T(1.0) / square_root(w.pair.high);
  const Sum<T> square = two_product(y, y);
  const T e = subtract_product<fuses>(
      subtract_product<fuses>(one_minus_product(w.pair.high, square.high), w.pair.high, square.low),
      w.pair.low, square.high);
  return {{y, T(0.5) * y * e}, y};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
