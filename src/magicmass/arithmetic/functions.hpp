// SPDX-License-Identifier: MIT
// Polynomials, arctangent, sine and cosine of DoubleDouble. A Tier brings its polynomials: those
// have `size`, `pairs`, `centre`, `high[]`, `low[]`, made in exact rationals by the generator.
#pragma once

#include "magicmass/arithmetic/double_double.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {
/// c_0 + c_1 z + ... in plain numbers, by halves (Estrin).
template <int size, class T>
[[gnu::always_inline]] inline T plain_polynomial(const double* c, T z) {
  if constexpr (size == 1) {
    return all<T>(c[0]);
  } else if constexpr (size == 2) {
    return fused(all<T>(c[1]), z, all<T>(c[0]));
  } else {
    constexpr int half = size > 8 ? 8 : size > 4 ? 4 : 2;
    T power = z * z;
    for (int k = 2; k < half; k *= 2) power = power * power;
    return fused(plain_polynomial<size - half>(c + half, z), power, plain_polynomial<half>(c, z));
  }
}
/// high + low + x y, where |x y| <= |high|/2.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> plus_product(double high, double low,
                                                           DoubleDouble<T> x, DoubleDouble<T> y) {
  const T c = all<T>(high);
  const T sum = fused(x.high, y.high, c);
  const T rest = fused(x.high, y.high, c - sum);  // c - sum is exact
  // y's low part comes last: a chain of these waits for one operation each.
  return {sum, fused(x.high, y.low, rest + fused(x.low, y.high, all<T>(low)))};
}
/// The polynomial P at z: its first P.pairs coefficients in two parts, the others in one.
template <const auto& P, class T>
[[gnu::always_inline]] inline DoubleDouble<T> polynomial(DoubleDouble<T> z) {
  constexpr int pairs = P.pairs;
  const T tail = z.high * plain_polynomial<P.size - pairs>(P.high + pairs, z.high);
  DoubleDouble<T> sum = fast_two_sum(all<T>(P.high[pairs - 1]), tail);
  sum.low = fused(z.low, all<T>(P.high[pairs]), sum.low + P.low[pairs - 1]);
#pragma GCC unroll 32
  for (int k = pairs - 2; k >= 0; --k) sum = plus_product(P.high[k], P.low[k], z, sum);
  return sum;
}

/// z - centre, 0 <= z <= 2 centre: the difference of the high parts is exact with its rest.
template <class T>
[[gnu::always_inline]] inline DoubleDouble<T> less_centre(DoubleDouble<T> z, double centre) {
  const DoubleDouble<T> difference = fast_two_sum(all<T>(-centre), z.high);
  return {difference.high, difference.low + z.low};
}
/// atan t where t^2 = z, 0 <= z <= 2 Tier::arc_tangent.centre.
template <class Tier, class T>
[[gnu::always_inline]] inline DoubleDouble<T> arc_tangent(DoubleDouble<T> t, DoubleDouble<T> z) {
  return t * polynomial<Tier::arc_tangent>(less_centre(z, Tier::arc_tangent.centre));
}

/// x^n by squaring, 0 < x <= 1, n >= 0 whole; from 2^-200 down that. 1 for what is no such n.
inline DoubleDouble<double> power(DoubleDouble<double> x, double n) {
  const auto times_or_least = [](DoubleDouble<double> a, DoubleDouble<double> b) {
    const DoubleDouble<double> p = a * b;
    return p.high > 0x1p-200 ? fast_two_sum(p.high, p.low) : DoubleDouble<double>{0x1p-200, 0.0};
  };
  DoubleDouble<double> result{1.0, 0.0};
  x = fast_two_sum(x.high, x.low);
  for (std::int64_t left = n < 0x1p63 ? std::int64_t(n) : 0; left > 0; left /= 2) {
    if (left % 2 != 0) result = times_or_least(result, x);
    x = times_or_least(x, x);
  }
  return result;
}

template <class N>
struct SineCosine {
  N sine, cosine;
};
/// |x| <= pi/6 or a little more.
template <class Tier, class T>
[[gnu::always_inline]] inline SineCosine<DoubleDouble<T>> sine_cosine_small(DoubleDouble<T> x) {
  const DoubleDouble<T> square = x * x;
  return {x * polynomial<Tier::small_sine>(square), polynomial<Tier::small_cosine>(square)};
}
/// 0 <= x <= 3 pi/4: above pi/4 a quarter turn is taken off. The cosine's
/// low part may be large against its high part, near a quarter turn.
template <class Tier, class T>
[[gnu::always_inline]] inline SineCosine<DoubleDouble<T>> sine_cosine(DoubleDouble<T> x) {
  constexpr double quarter = 0x1.921fb54442d18p+0;
  constexpr double quarter_low = 0x1.1a62633145c07p-54;
  const auto turns = is_above(x.high, all<T>(quarter / 2));
  const DoubleDouble<T> y{x.high - select(turns, all<T>(quarter), T{}),
                          x.low - select(turns, all<T>(quarter_low), T{})};
  const DoubleDouble<T> square = y * y;
  const DoubleDouble<T> sine = y * polynomial<Tier::sine>(square);
  const DoubleDouble<T> cosine = polynomial<Tier::cosine>(square);
  return {{select(turns, cosine.high, sine.high), select(turns, cosine.low, sine.low)},
          {select(turns, -sine.high, cosine.high), select(turns, -sine.low, cosine.low)}};
}
}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
