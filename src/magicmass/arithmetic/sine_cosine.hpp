// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/bounded.hpp"
#include "magicmass/arithmetic/cubic_term.hpp"
#include "magicmass/arithmetic/estrin.hpp"
#include "magicmass/arithmetic/multiply_add.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/polynomials.hpp"
#include "magicmass/arithmetic/sine_cosine_table.hpp"
#include "magicmass/arithmetic/table_columns.hpp"
#include "magicmass/arithmetic/tracked.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

template <class Number>
struct SineCosine {
  Number sine;
  Number cosine;
};

/// pi/2 as the sum of three doubles.
inline constexpr double half_pi[] = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54,
                                     -0x1.f1976b7ed8fbcp-110};

/// sin x and cos x for 0 <= x <= 2.35, within 0.2 2^-53 of themselves or 2^-109, and what the error of x makes of them.
template <class T>
[[gnu::always_inline]] inline SineCosine<Pair<T>> sine_cosine(Pair<T> x) {
  // x = r or x = pi/2 - r with |r| <= pi/4 + 1/64; the subtraction of the high parts is exact (Sterbenz).
  const auto is_turned = x.high > T(0.8);
  const Sum<T> r = ordered_sum(select(is_turned, T(half_pi[0]) - x.high, x.high),
                               select(is_turned, T(half_pi[1]) - x.low, x.low));
  // sin r = r - r^3/6 + (r.low cos r + r z^2 p(z)): what is not exact here is at most 0.007 of it, rounded six times, 0.04 2^-53;
  // 1 - z/2 stands for the cosine, off by 0.02. cos r = 1 - r^2/2 + (r^4 q(r^2) - r r.low): r^2/2 in two parts, and the
  // rest is below 0.02.
  const T z = r.high * r.high;
  const T z_low = product_error(r.high, r.high, z);
  const T half = T(0.5) * z;
  const Sum<T> top = ordered_difference(T(1.0), half);
  const T fourth = z * z;
  const CubicTerm<T> cubic(minus_sixth, r.high, z);
  const Sum<T> head = ordered_sum(r.high, cubic.head);
  const Sum<T> sine = ordered_sum(
      head.high, head.low + (r.low * top.high +
                             (cubic.tail + (r.high * fourth) * polynomial(sine_coefficients, z))));
  const Sum<T> cosine = ordered_sum(
      top.high,
      top.low + (fourth * polynomial(cosine_coefficients, z) - (r.high * r.low + T(0.5) * z_low)));
  const Pair<T> s{sine.high, sine.low}, c{cosine.high, cosine.low};
  return {select(is_turned, c, s), select(is_turned, s, c)};
}

/// sin x and cos x for 0 <= x <= 3.14, within 2^-70.1 of themselves or 2^-80, and what the error of x makes of them, for x
/// within 2^-84 of its size, as sums and products of arctangents, whole numbers and pi are. Outside nothing is certain.
template <class T, bool fuses>
[[gnu::always_inline]] inline SineCosine<Tracked<T, fuses>> sine_cosine(Tracked<T, fuses> x) {
  // x = c + d, c = j/256, |d| <= 2^-9, without reduction. sin(d + low) = d + (low cos d - d^3/6 + ...), the cube rounded
  // at 2^-72.6 d, and cos(d + low) - 1 = -d^2/2 + d^4/24 - ... - low sin d, at most 2^-19: an error of 2^-53 of it from d^2, and five
  // roundings of half of that until it is part of the sum, 3.5 2^-72; |low| <= 2^-37 |x|.
  const auto is_known = (x.pair.high > T(-0x1p-10)) & (x.pair.high <= T(3.1406));
  const NearestNode<T> node = nearest_node(x.pair.high);
  const T d = x.pair.high - node.at;
  const T low = x.pair.low;
  const T z = d * d;
  const T cube = d * z *
                 subtract_product<fuses>(
                     T(0x1.5555555555555p-3), z,
                     subtract_product<fuses>(T(0x1.1111111111111p-7), z, T(0x1.a01a01a01a01ap-13)));
  const T of_sine = subtract_product<fuses>(low - cube, T(0.5) * z, low);
  const T square_terms = multiply_add<fuses>(
      z, subtract_product<fuses>(T(0x1.5555555555555p-5), z, T(0x1.6c16c16c16c17p-10)), T(-0.5));
  const T of_cosine = subtract_product<fuses>(z * square_terms, low, d - cube);
  const FourColumns<T> at_c = four_columns(sine_cosine_table, where(is_known, node.place));
  const Pair<T> s{at_c.first, at_c.third}, c{at_c.second, at_c.fourth};
  // the leading products and sums without error, then all that is below 2^-18 of them
  const Sum<T> c_d = two_product(c.high, d);
  const Sum<T> s_head = two_sum(s.high, c_d.high);
  const T s_rest = multiply_add<fuses>(
      c.high, of_sine,
      multiply_add<fuses>(s.high, of_cosine, multiply_add<fuses>(c.low, d, s.low)));
  const Sum<T> sine = ordered_sum(s_head.high, (s_head.low + c_d.low) + s_rest);
  const Sum<T> s_d = two_product(s.high, d);
  const Sum<T> c_head = two_sum(c.high, -s_d.high);
  const T c_rest = subtract_product<fuses>(
      multiply_add<fuses>(c.high, of_cosine, subtract_product<fuses>(c.low, s.low, d)), s.high,
      of_sine);
  const Sum<T> cosine = ordered_sum(c_head.high, (c_head.low - s_d.low) + c_rest);
  const T of_argument = select(is_known, T(0x1p-14) * x.size, T(HUGE_VAL));
  return {{{sine.high, sine.low}, magnitude(sine.high) + of_argument},
          {{cosine.high, cosine.low}, (magnitude(cosine.high) + T(0x1p-10)) + of_argument}};
}

/// sin x and cos x for |x| <= 3.9, within 2^-88 of themselves and what the error of x makes of them. Outside nothing is
/// certain.
template <class T>
[[gnu::always_inline]] inline SineCosine<Bounded<T>> sine_cosine(Bounded<T> x) {
  // x = r + q pi/2, |r| <= pi/4 + tiny, q = -2 to 2: q times a part of pi/2 is exact, and so is the first
  // subtraction (Sterbenz, or q = 0). What is left of pi/2 is below 2^-161.
  const T q = nearest_whole(x.pair.high * T(0x1.45f306dc9c883p-1));
  const Sum<T> first = two_sum(x.pair.high - q * T(half_pi[0]), -(q * T(half_pi[1])));
  const Sum<T> second = two_sum(first.high, x.pair.low);
  const Sum<T> reduced = two_sum(second.high, (first.low + second.low) - q * T(half_pi[2]));
  // |r| = c + d, c = j/256 next to it, |d| <= 2^-9.
  const auto is_below = reduced.high < T(0.0);
  const T r = magnitude(reduced.high);
  const auto is_known = magnitude(x.pair.high) <= T(3.9);
  const NearestNode<T> node = nearest_node(r);
  const Sum<T> rest = two_sum(r - node.at, select(is_below, -reduced.low, reduced.low));
  const Pair<T> d{rest.high, rest.low};
  // sin d = d - d z/6 + d z^2 (1/120 - z/5040), z = d^2 <= 2^-18: d z/6 as a pair, the last term, below 2^-42 d, with
  // three roundings; what follows it is below 2^-90 d. cos d - 1 = -z/2 + z^2 (1/24 - z/720 + z^2/40320) likewise.
  const Pair<T> z = d * d;
  const T square = z.high * z.high;
  const Pair<T> sixth{T(-0x1.5555555555555p-3), T(-0x1.5555555555555p-57)};
  const Pair<T> sine_d =
      d + ((d * z) * sixth +
           d.high * square * (T(0x1.1111111111111p-7) - z.high * T(0x1.a01a01a01a01ap-13)));
  const Pair<T> cosine_d_less_one =
      scaled(z, -0.5) +
      square * (T(0x1.5555555555555p-5) -
                z.high * (T(0x1.6c16c16c16c17p-10) - z.high * T(0x1.a01a01a01a01ap-16)));
  const FourColumns<T> at_c = four_columns(sine_cosine_table, where(is_known, node.place));
  const Pair<T> sine_c{at_c.first, at_c.third}, cosine_c{at_c.second, at_c.fourth};
  Pair<T> sine = normalised(sine_c + (sine_c * cosine_d_less_one + cosine_c * sine_d));
  const Pair<T> cosine = normalised(cosine_c + (cosine_c * cosine_d_less_one - sine_c * sine_d));
  sine = select(is_below, -sine, sine);
  // by the number of quarter turns
  const auto is_odd = magnitude(q) == T(1.0);
  const auto is_half = magnitude(q) == T(2.0);
  const auto is_back = q < T(0.0);
  Pair<T> s = select(is_odd, select(is_back, -cosine, cosine), select(is_half, -sine, sine));
  Pair<T> c = select(is_odd, select(is_back, sine, -sine), select(is_half, -cosine, cosine));
  const auto bound = [&](T of_value, T of_slope) {
    return select(is_known,
                  x.error * (magnitude(of_slope) + x.error) +
                      (T(0x1p-88) * magnitude(of_value) + T(0x1p-158)),
                  T(HUGE_VAL));
  };
  return {{s, bound(s.high, c.high)}, {c, bound(c.high, s.high)}};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
