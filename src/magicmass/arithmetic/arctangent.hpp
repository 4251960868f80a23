// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/arctangent_table.hpp"
#include "magicmass/arithmetic/bounded.hpp"
#include "magicmass/arithmetic/cubic_term.hpp"
#include "magicmass/arithmetic/estrin.hpp"
#include "magicmass/arithmetic/multiply_add.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/polynomials.hpp"
#include "magicmass/arithmetic/table_columns.hpp"
#include "magicmass/arithmetic/tracked.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// atan t for 0 <= t <= 0.577, within 0.25 2^-53 of itself and what the error of t makes of it; its low part may be 2^-5 of it.
template <class T>
[[gnu::always_inline]] inline Pair<T> arctangent(Pair<T> t) {
  // atan t = t - t^3/3 + t z^2 p(z), z = t^2 <= 1/3. What is not exact here is at most 0.024 of the whole, and its roundings (z twice,
  // two more products, the polynomial's, the sum), each 2^-53 of it, cost 0.15 2^-53. t.low, at most 2^-53 of t, has the factor
  // 1 - 3/4 z, which should be 1/(1+z): off by 0.03 at most.
  const T z = t.high * t.high;
  const CubicTerm<T> cubic(minus_third, t.high, z);
  const Sum<T> head = ordered_sum(t.high, cubic.head);
  const T rest = cubic.tail + (t.high * (z * z)) * polynomial(arctangent_coefficients, z);
  return {head.high, head.low + (t.low * (T(1.0) - T(0.75) * z) + rest)};
}

/// atan t for 0 <= t <= 1, within 2^-84 of itself and what the error of t makes of it.
template <class T, bool fuses>
[[gnu::always_inline]] inline Tracked<T, fuses> arctangent(Tracked<T, fuses> t) {
  // As below with w = quotient + rest. w^3/3 is taken as a pair, its error 2^-20 2^-104 of w; the next term is below 2^-38 w and
  // rounded at 2^-53 of itself.
  // lanes whose answer nobody takes may hold anything: they get a place in the table
  const auto is_in_table = (t.pair.high >= T(0.0)) & (t.pair.high <= T(1.0));
  const NearestNode<T> node = nearest_node(t.pair.high);
  const T c = node.at;
  const T above = t.pair.high - c;  // exact, as c is near or t.high below 2^-9
  const Sum<T> tc = two_product(t.pair.high, c);
  const Sum<T> below = ordered_sum(T(1.0), tc.high);
  const T inverse = T(1.0) / below.high;
  const T quotient = above * inverse;
  const T product = quotient * below.high;
  const T below_low = below.low + multiply_add<fuses>(t.pair.low, c, tc.low);
  const T rest = ((above - product) - product_error(quotient, below.high, product) +
                  subtract_product<fuses>(t.pair.low, quotient, below_low)) *
                 inverse;
  const Sum<T> z = two_product(quotient, quotient);
  const Sum<T> third = two_product(z.high, T(0x1.5555555555555p-2));
  const T third_low =
      multiply_add<fuses>(z.low, T(0x1.5555555555555p-2),
                          multiply_add<fuses>(z.high, T(0x1.5555555555555p-56), third.low));
  const Sum<T> cubic = two_product(quotient, third.high);
  const T cubic_low =
      multiply_add<fuses>(quotient, third_low, multiply_add<fuses>(rest, z.high, cubic.low));
  const T next_terms = subtract_product<fuses>(
      T(0x1.999999999999ap-3), z.high,
      subtract_product<fuses>(T(0x1.2492492492492p-3), z.high, T(0x1.c71c71c71c71cp-4)));
  const TwoColumns<T> of_c = two_columns(arctangent_table, where(is_in_table, node.place));
  const Sum<T> head = ordered_sum(of_c.first, quotient);
  const Sum<T> body = ordered_sum(head.high, -cubic.high);
  const T low = multiply_add<fuses>(quotient * (z.high * z.high), next_terms,
                                    ((head.low + body.low) + (of_c.second + rest)) - cubic_low);
  return {{body.high, low}, body.high};
}

/// atan t for 0 <= t <= 1, within 2^-88 of itself and what the error of t makes of it (the slope is at most 1).
template <class T>
[[gnu::always_inline]] inline Bounded<T> arctangent(Bounded<T> t) {
  // atan t = atan c + atan w with c = j/256 next to t and w = (t - c)/(1 + t c), |w| <= 2^-9.
  // atan w = w - w^3 (1/3 - w^2 (1/5 - w^2/7)); 1/3 - ... is a pair, and its inner part, below 2^-18/5, is rounded at
  // 2^-53 of itself: 2^-73 of w^2 <= 2^-18, so 2^-91 of w. The next term w^8/9 is below 2^-75 / 9 w^... of w: 2^-75.
  const auto is_in_table = (t.pair.high >= T(0.0)) & (t.pair.high <= T(1.0));
  const NearestNode<T> node = nearest_node(t.pair.high);
  const T c = node.at;
  const Pair<T> w =
      (t.pair + (-c)) / (Pair<T>::product(t.pair.high, c) + Pair<T>(t.pair.low * c) + T(1.0));
  const Pair<T> z = w * w;
  const T inner = z.high * (T(-0x1.999999999999ap-3) +
                            z.high * (T(0x1.2492492492492p-3) - z.high * T(0x1.c71c71c71c71cp-4)));
  const Pair<T> cubic = z * (Pair<T>(T(0x1.5555555555555p-2), T(0x1.5555555555555p-56)) + inner);
  const Pair<T> of_w = w - cubic * w;
  const TwoColumns<T> of_c = two_columns(arctangent_table, where(is_in_table, node.place));
  const Pair<T> sum = Pair<T>(of_c.first, of_c.second) + of_w;
  return {normalised(sum), t.error + T(0x1p-88) * sum.high};
}

/// atan t = asec(1 + x)/2 for t = sqrt(x/(2 + x)), given both: some number types have a better way from x.
template <class Number>
[[gnu::always_inline]] inline Number half_arcsecant(typename Number::Real, Number tangent) {
  return arctangent(tangent);
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
