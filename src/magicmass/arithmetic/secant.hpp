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

/// 1/cos(pi/m) - 1 for two m, from m^2, m^2 - 4 and the product of these, rounded.
[[gnu::always_inline]] inline Pair<Lanes<2>> secant_quotient(Lanes<2> square,
                                                             Pair<Lanes<2>> difference,
                                                             Lanes<2> product) {
  // S(x)/(m^2 - 4) with S(x) = (1/cos(pi/m) - 1)(m^2 - 4) = S(0) + x p(x), x = 1/m^2, from 4.93 to 5. One division: 1/product
  // times the one factor is the inverse of the other. S(0)/(m^2 - 4) does not wait for p; its rest is exact but for a
  // few roundings of 2^-53 of it. x p is at most 0.62 x, an eighth of x relative to S, in error by 3 2^-53 from x,
  // by as much from roundings and by 2 2^-53 from those of `low`: by 2^-53 x; p adds less than 2^-60 x.
  using T = Lanes<2>;
  const T inverse_of_both = T(1.0) / product;
  const T x = inverse_of_both * difference.high;
  const T inverse = inverse_of_both * square;
  const T at_0(secant_at_0[0]);
  const T quotient = at_0 * inverse;
  const T multiple = quotient * difference.high;
  const T rest = ((at_0 - multiple) - product_error(quotient, difference.high, multiple)) +
                 (T(secant_at_0[1]) - quotient * difference.low);
  return {quotient, (rest + x * polynomial(secant_coefficients, x)) * inverse};
}

/// 1/cos(pi/m) - 1 for two numbers 3 <= m <= 2^100 side by side, each within 2^-52 x + 2^-98 of itself, x = 1/m^2; the low
/// part is at most 2^-6 of it.
[[gnu::always_inline]] inline Secants<Tabled<double>> secants_less_one(Tabled<double> first,
                                                                       Tabled<double> second) {
  using T = Lanes<2>;
  const T m(T::Doubles{first.pair.high, second.pair.high});
  const T m_low(T::Doubles{first.pair.low, second.pair.low});
  const Sum<T> square = two_product(m, m);
  const Sum<T> difference = ordered_difference(square.high, T(4.0));
  const T low = difference.low + (square.low + (T(2.0) * m) * m_low);
  const Pair<T> both =
      secant_quotient(square.high, {difference.high, low}, square.high * difference.high);
  return {Tabled<double>(Pair<double>(both.high.v[0], both.low.v[0])),
          Tabled<double>(Pair<double>(both.high.v[1], both.low.v[1]))};
}

/// A whole number of at most 2^26, whose square is a double: sums of such and a double are exact. Only secants are pairs.
struct Whole {
  using Real = double;

  Pair<double> pair;

  Whole() = default;
  explicit Whole(double exact) : pair(exact) {}
  explicit Whole(Pair<double> value) : pair(value) {}

  friend Whole operator+(Whole x, double y) { return Whole(x.pair.high + y); }
  friend Whole scaled(Whole x, double power_of_two) { return Whole(x.pair.high * power_of_two); }
};

/// The same for these.
[[gnu::always_inline]] inline Secants<Whole> secants_less_one(Whole first, Whole second) {
  using T = Lanes<2>;
  const T m(T::Doubles{first.pair.high, second.pair.high});
  const T square = m * m;
  const T difference = square - T(4.0);
  const Pair<T> both = secant_quotient(square, Pair<T>(difference), square * difference);
  return {Whole(Pair<double>(both.high.v[0], both.low.v[0])),
          Whole(Pair<double>(both.high.v[1], both.low.v[1]))};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
