// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/half_arcsecant.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/product.hpp"
#include "magicmass/arithmetic/root_arctangent_table.hpp"
#include "magicmass/arithmetic/sine_cosine.hpp"
#include "magicmass/arithmetic/table_node.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A Pair whose arctangent, sine and cosine come from tables: for one number at a time, where a look-up costs less than the
/// long polynomials that suit lanes, and nothing is decided by a branch. Usual ones are of an alpha from 2^-120 to 1: no square of a
/// root overflows, and sums of two doubles begin with the larger.
template <class T, bool usual = false>
struct Tabled {
  using Real = T;

  Pair<T> pair;

  Tabled() = default;
  explicit Tabled(T exact) : pair(exact) {}
  explicit Tabled(Pair<T> value) : pair(value) {}

  static Tabled sum(T x, T y) {
    if constexpr (usual) return Tabled(normalised(Pair<T>(x, y)));
    return Tabled(Pair<T>::sum(x, y));
  }
  static Tabled product(T x, T y) { return Tabled(Pair<T>::product(x, y)); }

  struct Pi {};
  static Pi pi() { return {}; }
  /// pi - x, to be multiplied by plus or minus a power of two.
  struct FromPi {
    Pair<T> pair;
    friend Tabled operator*(FromPi x, T y) {
      return Tabled(Pair<T>(x.pair.high * y, x.pair.low * y));
    }
  };
  /// For pi/2 <= x.high <= 2 pi, where the high parts subtract exactly (Sterbenz).
  friend FromPi operator-(Pi, Tabled x) {
    const Pair<T> whole = Pair<T>::pi();
    return {Pair<T>(whole.high - x.pair.high, whole.low - x.pair.low)};
  }

  friend Tabled operator-(Tabled x) { return Tabled(-x.pair); }
  friend Tabled operator+(Tabled x, Tabled y) { return Tabled(x.pair + y.pair); }
  friend Tabled operator-(Tabled x, Tabled y) { return Tabled(x.pair - y.pair); }
  friend Tabled operator+(Tabled x, T y) { return Tabled(x.pair + y); }
  friend Tabled operator*(Tabled x, Tabled y) { return Tabled(x.pair * y.pair); }
  friend Tabled operator*(Tabled x, T y) { return Tabled(x.pair * y); }
  friend Tabled operator/(Tabled x, Tabled y) { return Tabled(x.pair / y.pair); }
  friend Tabled scaled(Tabled x, double power_of_two) {
    return Tabled(scaled(x.pair, power_of_two));
  }
  template <class Condition>
  friend Tabled select(Condition condition, Tabled yes, Tabled no) {
    return Tabled(select(condition, yes.pair, no.pair));
  }
  friend T rounded(Tabled x) { return rounded(x.pair); }
};

/// Scaled first: what is rounded among the subnormals is not doubled any more.
template <class T, bool usual>
[[gnu::always_inline]] inline T rounded(Product<Tabled<T, usual>> p) {
  return rounded(Product<Pair<T>>{scaled(p.x.pair, p.scale), p.y.pair, 1.0});
}
/// 1/y within 2^-100 for |y.low| <= 2^-50 |y.high|, low at most 2^-49 of high.
template <class T, bool usual>
[[gnu::always_inline]] inline Tabled<T, usual> reciprocal(Tabled<T, usual> y) {
  const T inverse = T(1.0) / y.pair.high;
  const T rest = one_minus_product(inverse, y.pair.high) - inverse * y.pair.low;
  return Tabled<T, usual>(Pair<T>(inverse, inverse * rest));
}
/// 1/sqrt(w) within 2^-98, its low part at most 2^-51 of it: for w from 2^-900 to 2^900, and by the pair's own beyond.
template <class T, bool usual>
[[gnu::always_inline]] inline Tabled<T, usual> reciprocal_square_root(Tabled<T, usual> of) {
  const Pair<T> w = of.pair;
  if constexpr (!usual) {
    if (!(w.high >= 0x1p-900 && w.high <= 0x1p900)) [[unlikely]]
      return Tabled<T>(reciprocal_square_root(w));
  }
  // The root and the quotient do not wait for each other. y is within 1.5 2^-53, so that what Newton's step leaves out, 3/8 e^2
  // with e = 1 - w y^2, is below 2^-104.
  const T y = square_root(w.high) * (T(1.0) / w.high);
  const Sum<T> square = two_product(y, y);
  const T e = one_minus_product(w.high, square.high) - (w.high * square.low + w.low * square.high);
  return Tabled<T, usual>(Pair<T>(y, T(0.5) * y * e));
}

/// atan t for 0 <= t <= 1, within the lesser of 2^-61 and 2^-51 t^2 + 2^-100 of itself and what the error of t makes of it.
/// Outside it means nothing.
[[gnu::always_inline]] inline Tabled<double> arctangent(Tabled<double> of) {
  // atan t = t F(t^2). With t.high^2 = z + z_low, z = c + d, c = j/256, |d| <= 2^-9: F = F(c) + d p(d) + z_low F'(c), and F' is
  // about p(0). All but F(c) is below 0.34 d + 2^-54, and what is rounded there, at 2^-53 of itself each, is p (less than
  // twice), its product with d, two sums and the product with t: within 5 2^-53 0.34 d, 2^-61.2 (0.34 z 2^-50.6 where j = 0).
  // t.low has the factor (t F(t^2))' = F + 2 z F', known to 2^-10 of itself; p is within 2^-66.
  const Pair<double> t = of.pair;
  const double z = t.high * t.high;
  const double z_low = product_error(t.high, t.high, z);
  const TableNode node = table_node<8>(root_arctangent_table, z);
  const double d = node.rest;
  const double* row = node.row;
  const double square = d * d;
  const double further = (row[3] + row[4] * d) + square * ((row[5] + row[6] * d) + square * row[7]);
  const double rest = ((row[1] + z_low * row[2]) + row[2] * d) + square * further;
  const Sum<double> product = two_product(t.high, row[0]);
  const double of_low = t.low * (row[0] + row[2] * (d + (z + z)));
  return Tabled<double>(
      normalised(Pair<double>(product.high, (product.low + of_low) + t.high * rest)));
}

/// atan t = asec(1 + x)/2 for 0 < x and t = sqrt(x/(2 + x)), as exactly as `arctangent`: below x = 1 from x, which is exact and
/// waits for nothing.
[[gnu::always_inline]] inline Tabled<double, true> half_arcsecant(double x, Tabled<double, true>) {
  return Tabled<double, true>(half_arcsecant_in_range<true>(x));
}
[[gnu::always_inline]] inline Tabled<double> half_arcsecant(double x, Tabled<double> tangent) {
  return x < 1.0 ? Tabled<double>(half_arcsecant_of(x)) : arctangent(tangent);
}

/// (c, -s) of (s, c).
[[gnu::always_inline]] inline Lanes<2> quarter_turned(Lanes<2> x) {
  return Lanes<2>(_mm_xor_pd(_mm_shuffle_pd(x.v, x.v, 1), _mm_set_pd(-0.0, 0.0)));
}

/// sin x and cos x for 0 <= x <= 3.14, within 2^-60 of themselves or 2^-60, and what the error of x makes of them; the sine within
/// 2^-60 of itself up to 3. |x.low| <= 2^-51 |x.high|, or 2^-50 where x.high is a multiple of 2^-52.
/// Outside they mean nothing.
template <bool usual>
[[gnu::always_inline]] inline SineCosine<Tabled<double, usual>> sine_cosine(
    Tabled<double, usual> of) {
  using Number = Tabled<double, usual>;
  // x = c + d + low, c = j/256, |d| <= 2^-9: sin(d + low) = d + of_sine, |of_sine| <= 2^-29.5 + 2^-52, less than 2^-66 of it left
  // out and rounded thrice; cos(d + low) - 1 = of_cosine, at most 2^-19, 2^-63.5 left out and rounded four times at that. Then
  // sin x = s + (c d + (c of_sine + s of_cosine)) with c d exact, and so is its sum with s; and cos x likewise, (c, -s) in place
  // of (s, c): both side by side.
  using T = Lanes<2>;
  const Pair<double> x = of.pair;
  const TableNode node = table_node<4>(sine_cosine_table, x.high);
  const double d = node.rest;
  const Pair<T> at_c(load<T>(node.row), load<T>(node.row + 2));
  const Pair<T> slope(quarter_turned(at_c.high), quarter_turned(at_c.low));
  const double z = d * d;
  const double of_sine = x.low - (d * z) * (0x1.5555555555555p-3 - z * 0x1.1111111111111p-7);
  const double of_cosine = z * (0x1.5555555555555p-5 * z - 0.5) - x.low * d;
  const Sum<T> step = two_product(slope.high, T(d));
  const Sum<T> head = two_sum(at_c.high, step.high);
  const T low = ((head.low + step.low) + (at_c.low + slope.low * T(d))) +
                (slope.high * T(of_sine) + at_c.high * T(of_cosine));
  const Pair<T> both = normalised(Pair<T>(head.high, low));
  return {Number(Pair<double>(both.high.v[0], both.low.v[0])),
          Number(Pair<double>(both.high.v[1], both.low.v[1]))};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
