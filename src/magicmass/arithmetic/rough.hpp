// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/product.hpp"
#include "magicmass/arithmetic/sine_cosine.hpp"


namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

/// A T that is as good as rounded: a result, or a factor of one.
template <class T>
struct Rounded {
  T value;

  friend Rounded operator-(Rounded x) { return {-x.value}; }
  friend Rounded operator*(Rounded x, Rounded y) { return {x.value * y.value}; }
  friend Rounded scaled(Rounded x, T power_of_two) { return {x.value * power_of_two}; }
  friend T rounded(Rounded x) { return x.value; }
};

/// 1 - below.
template <class T>
struct NearOne {
  T below;

  NearOne() = default;
  explicit NearOne(T exact) : below(T(1.0) - exact) {}
  template <class Condition>
  friend NearOne select(Condition condition, NearOne yes, NearOne no) {
    NearOne result;
    result.below = select(condition, yes.below, no.below);
    return result;
  }
};

template <class T>
struct Leading {
  T high, low;
  Leading() = default;
  Leading(T h, T l) : high(h), low(l) {}
  friend T rounded(Leading x) { return x.high + x.low; }
  friend Rounded<T> operator+(Leading x, Leading y) { return {rounded(x) + rounded(y)}; }
  friend Rounded<T> operator-(Leading x, Leading y) {
    return {(x.high - y.high) + (x.low - y.low)};
  }
  friend Rounded<T> operator*(Rounded<T> x, Leading y) { return x * Rounded<T>{rounded(y)}; }
  template <class Condition>
  friend Leading select(Condition condition, Leading yes, Leading no) {
    return {select(condition, yes.high, no.high), select(condition, yes.low, no.low)};
  }
};

template <class T>
struct Rough {
  using Real = T;

  T high;
  T low;

  Rough() = default;
  explicit Rough(T exact) : high(exact), low(0.0) {}
  Rough(T high_part, T low_part) : high(high_part), low(low_part) {}
  operator Leading<T>() const { return {high, low}; }

  struct Pi {};
  static Pi pi() { return {}; }

  static Rough sum(T x, T y) {
    const Sum<T> s = two_sum(x, y);
    return {s.high, s.low};
  }
  static Rough in_order(T x, T y) {
    const Sum<T> s = ordered_sum(x, y);
    return {s.high, s.low};
  }
  friend Rough operator-(Pi, Rough x) {
    return {T(0x1.921fb54442d18p+1) - x.high, T(0x1.1a62633145c07p-53) - x.low};
  }
  friend Rounded<T> operator+(Rough x, Rough y) {
    return {x.high + (y.high + (x.low + y.low))};
  }
  friend Rough operator-(Rough x, Rough y) {
    const Sum<T> s = two_difference(x.high, y.high);
    return {s.high, s.low + (x.low - y.low)};
  }
  friend Rough operator*(Rough x, Rough y) {
    const Sum<T> p = two_product(x.high, y.high);
    return {p.high, p.low + (x.high * y.low + x.low * y.high)};
  }
  friend Rough operator*(Rough x, T y) {
    const Sum<T> p = two_product(x.high, y);
    return {p.high, p.low + x.low * y};
  }
  friend Leading<T> operator*(Rough x, NearOne<T> y) { return {x.high, x.low - x.high * y.below}; }
  friend Rough scaled(Rough x, T power_of_two) {
    return {x.high * power_of_two, x.low * power_of_two};
  }
  template <class Condition>
  friend Rough select(Condition condition, Rough yes, Rough no) {
    return {select(condition, yes.high, no.high), select(condition, yes.low, no.low)};
  }
  friend T rounded(Rough x) { return x.high + x.low; }
  friend Rounded<T> as_rounded(Rough x) { return {x.high + x.low}; }
};

template <class T>
struct Product<Rough<T>> {
  struct Factor {
    T value;
    Factor(Rounded<T> x) : value(x.value) {}
    Factor(Rough<T> x) : value(rounded(x)) {}
  };
  Factor x;
  Rough<T> y;
  double scale;
  friend T rounded(Product p) {
    return T(p.scale) * (p.x.value * p.y.high + p.x.value * p.y.low);
  }
};

template <class T>
[[gnu::always_inline]] inline Rough<T> reciprocal_square_root(Rough<T> w) {
  const T y = reciprocal_square_root_estimate(w.high);
  const T square = y * y;
  const T e = one_minus_product(w.high, square) - w.low * square;
  const Sum<T> root = ordered_sum(y, y * (e * (T(0.5) + T(0.375) * e)));
  return {root.high, root.low};
}

inline constexpr double rough_arctangent_coefficients[] = {
    -0x1.5555555555555p-2,
    0x1.99999999997ecp-3,
    -0x1.2492492481003p-3,
    0x1.c71c71bd73a8p-4,
    -0x1.745d15cebd683p-4,
    0x1.3b138e67fbe86p-4,
    -0x1.110ef0b75adafp-4,
    0x1.e1b42a4068727p-5,
    -0x1.adcd02f2e84cap-5,
    0x1.7eb1d8971bf5dp-5,
    -0x1.470e83bc25123p-5,
    0x1.ea7017f5e1c8ap-6,
    -0x1.10b3423904662p-6,
    0x1.3f1d9a64f7cbp-8,
};
inline constexpr double rough_sine_coefficients[] = {
    -0x1.5555555555554p-3,
    0x1.11111111109cp-7,
    -0x1.a01a019e234fep-13,
    0x1.71de372671f13p-19,
    -0x1.ae5f9e621b809p-26,
    0x1.5de60e8961addp-33,
};
inline constexpr double small_sine_coefficients[] = {
    -0x1.5555555555555p-3,
    0x1.1111111110f7bp-7,
    -0x1.a01a019f902b8p-13,
    0x1.71de39196b7ebp-19,
    -0x1.ae61ad4d0fb71p-26,
    0x1.5e8fb94e3335ep-33,
};
inline constexpr double small_cosine_coefficients[] = {
    0x1p-1,
    -0x1.5555555555515p-5,
    0x1.6c16c16bfd02cp-10,
    -0x1.a01a0134951b4p-16,
    0x1.27e43719eaf9fp-22,
    -0x1.1da7850842dddp-29,
};

template <class T>
[[gnu::always_inline]] inline Rough<T> arctangent(Rough<T> t) {
  const T z = t.high * t.high;
  const T rest = (t.high * z) * polynomial(rough_arctangent_coefficients, z);
  const Sum<T> all = ordered_sum(t.high, rest + t.low * (T(1.0) - T(0.75) * z));
  return {all.high, all.low};
}

template <class T>
[[gnu::always_inline]] inline SineCosine<Rough<T>> sine_cosine(Rough<T> x) {
  const auto is_turned = x.high > T(0.8);
  const Sum<T> r = ordered_sum(select(is_turned, T(half_pi[0]) - x.high, x.high),
                               select(is_turned, T(half_pi[1]) - x.low, x.low));
  const T z = r.high * r.high;
  const T half = T(0.5) * z;
  const Sum<T> top = ordered_difference(T(1.0), half);
  const T fourth = z * z;
  const Rough<T> s{r.high,
                   r.low * top.high + (r.high * z) * polynomial(rough_sine_coefficients, z)};
  const Rough<T> c{top.high,
                   top.low + (fourth * polynomial(cosine_coefficients, z) - r.high * r.low)};
  return {select(is_turned, c, s), select(is_turned, s, c)};
}

template <class T>
struct SmallTurn {
  Leading<T> sine;
  NearOne<T> cosine;
};

template <class T>
[[gnu::always_inline]] inline SmallTurn<T> sine_cosine_of_small(Rough<T> x) {
  const Sum<T> r = ordered_sum(x.high, x.low);
  const T z = r.high * r.high;
  SmallTurn<T> turn;
  turn.sine = {r.high, r.low + (r.high * z) * polynomial(small_sine_coefficients, z)};
  turn.cosine.below = z * polynomial(small_cosine_coefficients, z);
  return turn;
}
template <class T>
auto sine_cosine_of_small(Tracked<T> x) { return sine_cosine(x); }
template <class T>
auto sine_cosine_of_small(Bounded<T> x) { return sine_cosine(x); }
template <class T>
auto sine_cosine_of_small(Pair<T> x) { return sine_cosine(x); }

template <class Number> struct Small { using Sine = Number; using Cosine=Number; using Result=Number; };
template <class T> struct Small<Rough<T>> { using Sine = Leading<T>; using Cosine=NearOne<T>; using Result=Rounded<T>; };

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
