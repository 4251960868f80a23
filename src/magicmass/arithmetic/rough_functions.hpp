// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/chains.hpp"
#include "magicmass/arithmetic/polynomials.hpp"
#include "magicmass/arithmetic/rough.hpp"
#include "magicmass/arithmetic/sine_cosine.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// 1/sqrt(w) within 2^-66, for w from 2^-120 to 2^121; its lead has 24 bits, its rest is at most 2^-22 of it. As for a
/// Pair, but not added up.
template <class T>
[[gnu::always_inline]] inline Cut<T> reciprocal_square_root(Rough<T> w) {
  const T y = reciprocal_square_root_estimate(w.high);
  const T square = y * y;
  const T e = one_minus_product_by_short(w.high, square) - w.low * square;
  return {y, y * (e * (T(0.5) + T(0.375) * e))};
}

/// 1/w within 2^-66, for w from 2^-120 to 2^121; its lead has 24 bits, its rest is at most 2^-22 of it.
template <class T>
[[gnu::always_inline]] inline Cut<T> reciprocal(Rough<T> w) {
  const T y = reciprocal_estimate(w.high);
  const T e = one_minus_product_by_short(w.high, y) - w.low * y;
  return {y, y * (e + e * e)};
}

/// Of atan t = t - t^3/4 - t^3 p(z)/q(z), z = t^2: dividing costs less than the terms that a polynomial would have more.
template <class T>
struct ArcTangentTerms {
  T square;  ///< z
  T cube;    ///< t^3
  T last;    ///< t^3 p(z)/q(z)
};
template <class T>
[[gnu::always_inline]] inline ArcTangentTerms<T> arctangent_terms(T t) {
  const T z = t * t;
  const T cube = t * z;
  return {z, cube,
          cube * (one_chain(rough_arctangent_numerator, z) /
                  one_chain(rough_arctangent_denominator, z))};
}

/// atan t for 0 <= t <= 0.577, within 0.35 2^-53 of itself and what the error of t makes of it; its low part may be 2^-6 of it.
/// |t.low| <= 2^-53 |t|.
template <class T>
[[gnu::always_inline]] inline Angle<T> arctangent(Rough<T> t) {
  // z <= 1/3. t^3 is rounded twice, each 2^-53 of it, a quarter of which is at most 0.092 of the whole; t^3 p/q is at most 0.012 of
  // the whole and rounded ten times: p thrice, as its terms are a third more than it, q twice, they themselves and their quotient
  // once, t^3 twice. t.low has the factor 1 - 3/4 z, which should be 1/(1+z): off by 0.03 at most. In all 0.35.
  const ArcTangentTerms<T> terms = arctangent_terms(t.high);
  const Sum<T> head = ordered_sum(t.high, T(-0.25) * terms.cube);
  const T rest = t.low * (T(1.0) - T(0.75) * terms.square) - terms.last;
  return {head.high, head.low + rest};
}

/// The same of a tangent cut in two, added up: within 0.4 2^-53, its low part at most 2^-52 of it.
template <class T>
[[gnu::always_inline]] inline Angle<T> arctangent(Cut<T> tangent) {
  // As above, but that t^3/4 and t^3 p/q are added up first. That is rounded once more: by 0.1 2^-53 of the whole at most, and by 2^-58,
  // 0.06 2^-53 of the whole, at the end, where the other errors are largest.
  const Rough<T> t = Rough<T>::in_order(tangent.lead, tangent.rest);
  const ArcTangentTerms<T> terms = arctangent_terms(t.high);
  const Sum<T> angle = ordered_difference(t.high, plus_exact(terms.last, T(0.25), terms.cube));
  return {angle.high, angle.low + t.low * (T(1.0) - T(0.75) * terms.square)};
}

/// sin x and cos x for 0 <= x <= 2.35, each within 0.5 2^-53 of itself or 2^-57, and what the error of x makes of them, for
/// |x.low| <= 2^-6 |x|. Its low may be 2^-5 of it.
template <class T>
[[gnu::always_inline]] inline SineCosine<Rough<T>> sine_cosine(Rough<T> x) {
  // As for a Pair, x = r or pi/2 - r. sin r = r - r^3/8 + r^3 p(z), z = r^2 <= 0.642: r^3 is rounded twice, each 2^-53 of it, an eighth
  // of which is at most 0.09 of the whole; r^3 p(z) is at most 0.027 of it and rounded four times more: 0.33. cos r = 1 - z/2 + (z^2
  // q(z) - r r.low): z/2 is off by 2^-55 at most, 0.36 2^-53 of the whole, and the rest is below 0.025 of it: 0.49.
  const auto is_turned = x.high > T(0.8);
  const Sum<T> r = ordered_sum(select(is_turned, T(half_pi[0]) - x.high, x.high),
                               select(is_turned, T(half_pi[1]) - x.low, x.low));
  const T z = r.high * r.high;
  const Sum<T> top = ordered_difference(T(1.0), T(0.5) * z);
  const T cube = r.high * z;
  const Sum<T> head = ordered_sum(r.high, T(-0.125) * cube);
  const Rough<T> s = Rough<T>::in_order(
      head.high, head.low + (r.low * top.high + cube * two_chains(rough_sine_coefficients, z)));
  const Rough<T> c{top.high,
                   top.low + ((z * z) * two_chains(cosine_coefficients, z) - r.high * r.low)};
  return {select(is_turned, c, s), select(is_turned, s, c)};
}

template <class T>
struct SmallSineCosine {
  Cut<T> sine;
  NearOne<T> cosine;
};

/// sin |x| within 0.3 2^-53 of itself and 1 - cos x within 0.35 2^-53, and what the error of x makes of them, for |x| <= pi/6 +
/// 2^-20, |x.low| <= 2^-51; the low may be the larger where both are next to 0.
template <class T>
[[gnu::always_inline]] inline SmallSineCosine<T> small_sine_cosine(Magnitude<T> x) {
  // x^3 p(z), z = x^2 <= 0.275, is at most 0.048 of the sine and rounded five times; x.low has the factor 1 - z/2 instead of the
  // cosine, 0.004 off. z/2 is rounded by 2^-56, and the difference, at most 0.134, by as much; what is subtracted is below 0.004 of 1.
  const T z = x.high * x.high;
  const T half = T(0.5) * z;
  const T lead = leading<26>(x.high);
  const T cubic = (x.high * z) * two_chains(small_sine_coefficients, z);
  const T rest = (x.high - lead) + ((x.low - x.low * half) + cubic);
  const T of_sign = x.high + x.low;
  SmallSineCosine<T> turned;
  turned.sine = {times_sign_of(lead, of_sign), times_sign_of(rest, of_sign)};
  turned.cosine.below =
      half + (x.high * x.low - (z * z) * two_chains(small_cosine_coefficients, z));
  return turned;
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
