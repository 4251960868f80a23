// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/estrin.hpp"
#include "magicmass/arithmetic/polynomials.hpp"
#include "magicmass/arithmetic/tabled.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

template <class Number>
struct Secants {
  Number first;
  Number second;
};

/// 1/cos(pi/m) - 1 for two numbers 3 <= m <= 2^100 side by side, each within 2^-53 x + 2^-98 of itself, x = 1/m^2.
[[gnu::always_inline]] inline Secants<Tabled<double>> secants_less_one(Tabled<double> first,
                                                                       Tabled<double> second) {
  // S(x)/(m^2 - 4) with S(x) = S(0) + x S'(0) + x^2 p(x) from 4.93 to 5. One division: 1/(m^2 (m^2 - 4)) times the one factor
  // is the inverse of the other. What S(0) does not hold is at most 0.62 x, an eighth of x relative to S, in error by 3 2^-53
  // from x and as much from roundings: 2^-53.4 x, and p adds less than 2^-62 x. S(0) is within 2^-106, and the quotient's
  // rest, some 2^-51 of it, is rounded a few times.
  using T = Lanes<2>;
  const T m(T::Doubles{first.pair.high, second.pair.high});
  const T m_low(T::Doubles{first.pair.low, second.pair.low});
  const Sum<T> square = two_product(m, m);
  const T square_low = square.low + (T(2.0) * m) * m_low;
  const Sum<T> difference = ordered_difference(square.high, T(4.0));
  const T divisor_low = difference.low + square_low;
  const T inverse_of_both = T(1.0) / (square.high * difference.high);
  const T x = inverse_of_both * difference.high;
  const T inverse = inverse_of_both * square.high;
  const Sum<T> numerator = ordered_sum(
      T(secant_at_0[0]), x * (T(secant_slope) + x * polynomial(secant_coefficients, x)));
  const T quotient = numerator.high * inverse;
  const T product = quotient * difference.high;
  const T rest = ((numerator.high - product) - product_error(quotient, difference.high, product)) +
                 ((numerator.low + T(secant_at_0[1])) - quotient * divisor_low);
  const T low = rest * inverse;
  return {Tabled<double>(Pair<double>(quotient.v[0], low.v[0])),
          Tabled<double>(Pair<double>(quotient.v[1], low.v[1]))};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
