// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/pair.hpp"
#include "magicmass/arithmetic/product.hpp"
#include "magicmass/arithmetic/root_arctangent_table.hpp"
#include "magicmass/arithmetic/sine_cosine.hpp"

namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A Pair whose arctangent, sine and cosine come from tables: for one number at a time, where a look-up costs less than the
/// long polynomials that suit lanes, and nothing is decided by a branch.
template <class T>
struct Tabled {
  using Real = T;

  Pair<T> pair;

  Tabled() = default;
  explicit Tabled(T exact) : pair(exact) {}
  explicit Tabled(Pair<T> value) : pair(value) {}

  static Tabled sum(T x, T y) { return Tabled(Pair<T>::sum(x, y)); }
  static Tabled product(T x, T y) { return Tabled(Pair<T>::product(x, y)); }
  static Tabled pi() { return Tabled(Pair<T>::pi()); }

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

template <class T>
[[gnu::always_inline]] inline T rounded(Product<Tabled<T>> p) {
  return rounded(Product<Pair<T>>{p.x.pair, p.y.pair, p.scale});
}
template <class T>
[[gnu::always_inline]] inline Tabled<T> reciprocal(Tabled<T> y) {
  return Tabled<T>(reciprocal(y.pair));
}
template <class T>
[[gnu::always_inline]] inline Tabled<T> reciprocal_square_root(Tabled<T> w) {
  return Tabled<T>(reciprocal_square_root(w.pair));
}

/// atan t for 0 <= t <= 1, within the lesser of 2^-61 and 2^-51 t^2 + 2^-100 of itself and what the error of t makes of it.
/// Outside it means nothing.
template <class T>
[[gnu::always_inline]] inline Pair<T> table_arctangent(Pair<T> t) {
  // atan t = t F(t^2). With t.high^2 = z + z_low, z = c + d, c = j/256, |d| <= 2^-9: F = F(c) + d p(d) + z_low F'(c), and F' is
  // about p(0). All but F(c) is below 0.34 d + 2^-54, and what is rounded there, at 2^-53 of itself each, is p (less than
  // twice), its product with d, two sums and the product with t: within 5 2^-53 0.34 d, 2^-61.2 (0.34 z 2^-50.6 where j = 0).
  // t.low has the factor (t F(t^2))' = F + 2 z F', known to 2^-10 of itself; p is within 2^-66.
  const T z = t.high * t.high;
  const T z_low = product_error(t.high, t.high, z);
  const auto is_in_table = z <= T(1.0);
  const T j = where(is_in_table, nearest_whole(z * T(256.0)));
  const T d = z - j * T(0x1p-8);  // exact
  const auto column = [&]<int k>() { return gather<8, k>(root_arctangent_table, j); };
  const T slope = column.template operator()<2>();
  const T square = d * d;
  const T p = (slope + column.template operator()<3>() * d) +
              square * ((column.template operator()<4>() + column.template operator()<5>() * d) +
                        square * (column.template operator()<6>() +
                                  column.template operator()<7>() * d));
  const T at_node = column.template operator()<0>();
  const T rest = column.template operator()<1>() + (d * p + z_low * slope);
  const Sum<T> product = two_product(t.high, at_node);
  return normalised(
      Pair<T>(product.high,
              product.low + (t.high * rest + t.low * (at_node + slope * (d + (z + z))))));
}

template <class T>
[[gnu::always_inline]] inline Tabled<T> arctangent(Tabled<T> t) {
  return Tabled<T>(table_arctangent(t.pair));
}

/// sin x and cos x for 0 <= x <= 3.14, within 2^-60 of themselves or 2^-75, and what the error of x makes of them.
/// Outside they mean nothing.
template <class T>
[[gnu::always_inline]] inline SineCosine<Tabled<T>> sine_cosine(Tabled<T> unordered) {
  // x = c + d + low, c = j/256, |d| <= 2^-9: sin(d + low) = d + of_sine, |of_sine| <= 2^-29.5 + 2^-52, less than 2^-66 of it left
  // out and rounded thrice; cos(d + low) - 1 = of_cosine, at most 2^-19, 2^-63.5 left out and rounded four times at that. Then
  // sin x = s + (c d + (c of_sine + s of_cosine)) with c d and the sum with s exact, and cos x likewise.
  const Pair<T> x = normalised(unordered.pair);
  const auto is_known = (x.high > T(-0x1p-10)) & (x.high <= T(3.1406));
  const T j = where(is_known, nearest_whole(x.high * T(256.0)));
  const T d = x.high - j * T(0x1p-8);
  const T z = d * d;
  const T of_sine = x.low - (d * z) * (T(0x1.5555555555555p-3) - z * T(0x1.1111111111111p-7));
  const T of_cosine = z * (T(0x1.5555555555555p-5) * z - T(0.5)) - x.low * d;
  const Pair<T> s{gather<4, 0>(sine_cosine_table, j), gather<4, 1>(sine_cosine_table, j)};
  const Pair<T> c{gather<4, 2>(sine_cosine_table, j), gather<4, 3>(sine_cosine_table, j)};
  const Sum<T> c_d = two_product(c.high, d);
  const Sum<T> s_head = two_sum(s.high, c_d.high);
  const Sum<T> s_d = two_product(s.high, d);
  const Sum<T> c_head = two_difference(c.high, s_d.high);
  const T s_rest = (s.low + c.low * d) + (c.high * of_sine + s.high * of_cosine);
  const T c_rest = (c.low - s.low * d) + (c.high * of_cosine - s.high * of_sine);
  return {Tabled<T>(normalised(Pair<T>(s_head.high, (s_head.low + c_d.low) + s_rest))),
          Tabled<T>(normalised(Pair<T>(c_head.high, (c_head.low - s_d.low) + c_rest)))};
}

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
