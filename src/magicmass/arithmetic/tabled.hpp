// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "magicmass/arithmetic/half_arcsecant.hpp"
#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/product.hpp"
#include "magicmass/arithmetic/root_arctangent_table.hpp"
#include "magicmass/arithmetic/sine_cosine.hpp"
#include "magicmass/arithmetic/table_node.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// What is known of the alpha that numbers are of.
enum class Alphas {
  any,
  usual,  ///< from 2^-120 to 1: no square of a root overflows, and sums of two doubles begin with the larger
  vanishing  ///< below 2^-90: beside 1 it is nothing
};

/// An angle that is known roughly before it is known well, so that a table's row is on its way when it is.
template <Alphas alphas>
struct EarlyAngle {
  Pair<double> pair;
  double early;  ///< within 2^-19 of it

  friend EarlyAngle operator*(EarlyAngle x, double y) { return {x.pair * y, x.early * y}; }
};

/// The sine of an offset r from 0 to psi/4: at most tan(psi/4) cos r, so that sums of that product and it are in order.
struct LesserSine {
  Pair<double> pair;
};

/// A Pair whose arctangent, sine and cosine come from tables: for one number at a time, where a look-up costs less than the
/// long polynomials that suit lanes, and nothing is decided by a branch.
template <class T, Alphas alphas = Alphas::any>
struct Tabled {
  using Real = T;
  using Root = Tabled;
  using ArcTangent = std::conditional_t<alphas == Alphas::any, Tabled, EarlyAngle<alphas>>;
  using SmallSine = LesserSine;
  struct One {};
  using SmallCosine = std::conditional_t<alphas == Alphas::vanishing, One, Tabled>;

  Pair<T> pair;

  Tabled() = default;
  explicit Tabled(T exact) : pair(exact) {}
  explicit Tabled(Pair<T> value) : pair(value) {}
  Tabled(EarlyAngle<alphas> angle) : pair(angle.pair) {}

  static Tabled sum(T x, T y) {
    if constexpr (alphas == Alphas::usual) return Tabled(normalised(Pair<T>(x, y)));
    return Tabled(Pair<T>::sum(x, y));
  }
  static Tabled product(T x, T y) { return Tabled(Pair<T>::product(x, y)); }
  static Tabled half_arcsecant_tangent(T alpha);

  /// Pi times a power of two.
  struct Pi {
    double scale;
    friend Pi scaled(Pi x, double power_of_two) { return {x.scale * power_of_two}; }
  };
  static Pi pi() { return {1.0}; }
  /// pi - x, to be multiplied by plus or minus a power of two.
  struct FromPi {
    Pair<T> pair;
    T early;
    friend Tabled operator*(FromPi x, T y) {
      return Tabled(Pair<T>(x.pair.high * y, x.pair.low * y));
    }
  };
  /// For x.high from half of it to twice it, where the high parts subtract exactly (Sterbenz).
  friend FromPi operator-(Pi pi, EarlyAngle<alphas> x) {
    const Pair<T> whole = scaled(Pair<T>::pi(), pi.scale);
    return {Pair<T>(whole.high - x.pair.high, whole.low - x.pair.low), whole.high - x.early};
  }
  friend FromPi operator-(Pi pi, Tabled x) { return pi - EarlyAngle<alphas>{x.pair, x.pair.high}; }
  /// Of its sign only a sine wants to know, in the end.
  struct Magnitude {
    FromPi of;
  };
  friend Magnitude magnitude(FromPi x) { return {x}; }

  friend Tabled operator-(Tabled x) { return Tabled(-x.pair); }
  friend Tabled operator+(Tabled x, Tabled y) { return Tabled(x.pair + y.pair); }
  friend Tabled operator-(Tabled x, Tabled y) { return Tabled(x.pair - y.pair); }
  friend Tabled operator+(LesserSine y, Tabled x) {
    const Sum<T> s = ordered_sum(x.pair.high, y.pair.high);
    return Tabled(Pair<T>(s.high, s.low + (x.pair.low + y.pair.low)));
  }
  friend Tabled operator-(Tabled x, LesserSine y) {
    const Sum<T> s = ordered_difference(x.pair.high, y.pair.high);
    return Tabled(Pair<T>(s.high, s.low + (x.pair.low - y.pair.low)));
  }
  friend Tabled operator+(Tabled x, T y) { return Tabled(x.pair + y); }
  /// Where |x| >= |y|.
  friend Tabled operator-(T x, Tabled y) {
    const Sum<T> s = ordered_difference(x, y.pair.high);
    return Tabled(Pair<T>(s.high, s.low - y.pair.low));
  }
  friend Tabled operator*(Tabled x, Tabled y) { return Tabled(x.pair * y.pair); }
  friend Tabled operator*(Tabled x, T y) { return Tabled(x.pair * y); }
  friend Tabled operator*(Tabled x, One) { return x; }
  friend Tabled squared(Tabled x) {
    const Sum<T> p = two_product(x.pair.high, x.pair.high);
    return Tabled(Pair<T>(p.high, p.low + (x.pair.high + x.pair.high) * x.pair.low));
  }
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
template <class T, Alphas alphas>
[[gnu::always_inline]] inline T rounded(Product<Tabled<T, alphas>> p) {
  return rounded(Product<Pair<T>>{scaled(p.x.pair, p.scale), p.y.pair, 1.0});
}
/// 1/y within 2^-100 for |y.low| <= 2^-50 |y.high|, low at most 2^-49 of high.
template <class T, Alphas alphas>
[[gnu::always_inline]] inline Tabled<T, alphas> reciprocal(Tabled<T, alphas> y) {
  const T inverse = T(1.0) / y.pair.high;
  const T rest = one_minus_product(inverse, y.pair.high) - inverse * y.pair.low;
  return Tabled<T, alphas>(Pair<T>(inverse, inverse * rest));
}
/// 1/sqrt(w) within 2^-98, its low part at most 2^-51 of it: for w from 2^-900 to 2^900, and by the pair's own beyond.
template <class T, Alphas alphas>
[[gnu::always_inline]] inline Tabled<T, alphas> reciprocal_square_root(Tabled<T, alphas> of) {
  const Pair<T> w = of.pair;
  if constexpr (alphas == Alphas::any) {
    if (!(w.high >= 0x1p-900 && w.high <= 0x1p900)) [[unlikely]]
      return Tabled<T>(reciprocal_square_root(w));
  }
  // The root and the quotient do not wait for each other. y is within 1.5 2^-53, so that what Newton's step leaves out, 3/8 e^2
  // with e = 1 - w y^2, is below 2^-104.
  const T y = square_root(w.high) * (T(1.0) / w.high);
  const Sum<T> square = two_product(y, y);
  const T e = one_minus_product(w.high, square.high) - (w.high * square.low + w.low * square.high);
  return Tabled<T, alphas>(Pair<T>(y, T(0.5) * y * e));
}
/// sqrt(alpha/(2 + alpha)) of a usual alpha within 2^-100, its low part at most 2^-51 of it; of a vanishing one sqrt(alpha/2), which
/// leaves out alpha/4 of it.
template <class T, Alphas alphas>
[[gnu::always_inline]] inline Tabled<T, alphas> Tabled<T, alphas>::half_arcsecant_tangent(T alpha) {
  static_assert(alphas != Alphas::any);
  if constexpr (alphas == Alphas::vanishing) {
    const T square = T(0.5) * alpha, root = square_root(square);
    return Tabled(
        Pair<T>(root, (T(0.5) * less_product(square, root, root)) * (root * (T(1.0) / square))));
  }
  // t is within 2^-52 of itself, so that alpha - 2 square.high is exact (Sterbenz), and the rest of alpha = t^2 (2 + alpha) is 2^-51 of
  // alpha at most and rounded as a part of that; 1/(w t) is t/alpha but for as much. What Newton's step leaves out is the square of that.
  const T w = T(2.0) + alpha;
  const T t = square_root(alpha / w);
  const Sum<T> square = two_product(t, t);
  const Sum<T> product = two_product(alpha, square.high);
  const T rest = ((alpha - T(2.0) * square.high) - product.high) - (product.low + w * square.low);
  return Tabled(Pair<T>(t, (T(0.5) * rest) * (t * (T(1.0) / alpha))));
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
[[gnu::always_inline]] inline EarlyAngle<Alphas::usual> half_arcsecant(
    double x, Tabled<double, Alphas::usual>) {
  const HalfArcsecant made = half_arcsecant_parts<true>(x);
  return {half_arcsecant_in_range(made, x), made.root * made.early};
}
/// The tangent, but for x/6 of it.
[[gnu::always_inline]] inline EarlyAngle<Alphas::vanishing> half_arcsecant(
    double, Tabled<double, Alphas::vanishing> tangent) {
  return {tangent.pair, tangent.pair.high};
}
[[gnu::always_inline]] inline Tabled<double> half_arcsecant(double x, Tabled<double> tangent) {
  return x < 1.0 ? Tabled<double>(half_arcsecant_of(x)) : arctangent(tangent);
}

/// (c, -s) of (s, c).
[[gnu::always_inline]] inline Lanes<2> quarter_turned(Lanes<2> x) {
  return Lanes<2>(_mm_xor_pd(_mm_shuffle_pd(x.v, x.v, 1), _mm_set_pd(-0.0, 0.0)));
}

/// (sin x, cos x) of x = c + d + low from those of c, a row of the table, |d| <= 2^-9 and the least bit more; where they are sums in
/// order, as up to 1.
template <bool in_order>
[[gnu::always_inline]] inline Pair<Lanes<2>> sine_cosine_next_to(const double* row, double d,
                                                                 double x_low) {
  // sin(d + low) = d + of_sine, |of_sine| <= 2^-29.5 + 2^-52, less than 2^-66 of it left
  // out and rounded thrice; cos(d + low) - 1 = of_cosine, at most 2^-19, 2^-63.5 left out and rounded four times at that. Then
  // sin x = s + (c d + (c of_sine + s of_cosine)) with c d exact, and so is its sum with s; and cos x likewise, (c, -s) in place
  // of (s, c): both side by side.
  using T = Lanes<2>;
  const Pair<T> at_c(load<T>(row), load<T>(row + 2));
  const Pair<T> slope(quarter_turned(at_c.high), quarter_turned(at_c.low));
  const double z = d * d;
  const double of_sine = x_low - (d * z) * (0x1.5555555555555p-3 - z * 0x1.1111111111111p-7);
  const double of_cosine = z * (0x1.5555555555555p-5 * z - 0.5) - x_low * d;
  const Sum<T> step = two_product(slope.high, T(d));
  const Sum<T> head = in_order ? ordered_sum(at_c.high, step.high) : two_sum(at_c.high, step.high);
  const T low = ((head.low + step.low) + (at_c.low + slope.low * T(d))) +
                (slope.high * T(of_sine) + at_c.high * T(of_cosine));
  return normalised(Pair<T>(head.high, low));
}

/// sin x and cos x for 0 <= x <= pi, within 2^-60 of themselves or 2^-60, the sine within 2^-59 of itself but for 2^-102, and what the
/// error of x, or of pi - x, makes of them. |x.low| <= 2^-51 |x.high|, x.early within 2^-17. Up to 3.145 the sine has the right sign,
/// and beyond they mean nothing.
template <Alphas alphas>
[[gnu::always_inline]] inline SineCosine<Tabled<double, alphas>> sine_cosine(EarlyAngle<alphas> x) {
  using Number = Tabled<double, alphas>;
  // Beyond a quarter turn from pi - x, whose high part is exact; its low part, up to 2^-49.3, counts for 2^-19 of itself more than it
  // should. A branch: selections would wait for what is known early, and cost more than a guess that is wrong half of the time.
  double sign = 1.0;
  if (x.early > 0x1.921fb54442d18p+0) {
    const Pair<double> pi = Pair<double>::pi();
    x = {Pair<double>(pi.high - x.pair.high, pi.low - x.pair.low), magnitude(pi.high - x.early)};
    sign = -1.0;
  }
  const TableNode node = table_node<4>(sine_cosine_table, x.early);
  const Pair<Lanes<2>> both =
      sine_cosine_next_to<false>(node.row, x.pair.high - (x.early - node.rest), x.pair.low);
  return {Number(Pair<double>(both.high.v[0], both.low.v[0])),
          Number(Pair<double>(times_sign_of(both.high.v[1], sign),
                              times_sign_of(both.low.v[1], sign)))};
}

template <class Cosine>
struct SmallTurn {
  LesserSine sine;
  Cosine cosine;
};

/// sin |x| and cos x for |x| <= 0.8, as exactly; x.high a multiple of 2^-53, |x.low| <= 2^-51, x.early within 2^-18.
[[gnu::always_inline]] inline auto small_sine_cosine(Tabled<double, Alphas::usual>::Magnitude of) {
  using Number = Tabled<double, Alphas::usual>;
  // c is next to what is known early. The sign of x.high, which that of x may differ from by the least bit, is taken off first, as that
  // waits for nothing, and what is left of it in the end.
  const Pair<double> x = of.of.pair;
  const double early = magnitude(of.of.early);
  const TableNode node = table_node_inside<4>(sine_cosine_table, early);
  const double d = magnitude(x.high) - (early - node.rest);
  const Pair<Lanes<2>> both = sine_cosine_next_to<true>(node.row, d, times_sign_of(x.low, x.high));
  const double s = both.high.v[0];
  return SmallTurn<Number>{{Pair<double>(magnitude(s), times_sign_of(both.low.v[0], s))},
                           Number(Pair<double>(both.high.v[1], both.low.v[1]))};
}
/// |x| and 1, but for x^2/2.
[[gnu::always_inline]] inline auto small_sine_cosine(
    Tabled<double, Alphas::vanishing>::Magnitude of) {
  using Number = Tabled<double, Alphas::vanishing>;
  const Sum<double> x = two_sum(of.of.pair.high, of.of.pair.low);
  return SmallTurn<Number::One>{{Pair<double>(magnitude(x.high), times_sign_of(x.low, x.high))},
                                {}};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
