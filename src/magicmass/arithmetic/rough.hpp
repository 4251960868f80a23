// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/product.hpp"
#include "magicmass/arithmetic/arctangent.hpp"
#include "magicmass/arithmetic/sine_cosine.hpp"


namespace magicmass::arithmetic {
inline namespace MAGICMASS_TARGET {

template <class T, std::size_t size>
[[gnu::always_inline]] inline T two_chains(const double (&coefficients)[size], T z) {
  const T square = z * z;
  T even(coefficients[(size - 1) / 2 * 2]), odd(coefficients[size / 2 * 2 - 1]);
  for (std::size_t k = (size - 1) / 2 * 2; k >= 2; k -= 2) even = even * square + T(coefficients[k - 2]);
  for (std::size_t k = size / 2 * 2 - 1; k >= 3; k -= 2) odd = odd * square + T(coefficients[k - 2]);
  return even + odd * z;
}

/// A T that is as good as rounded: a result, or a factor of one.
template <class T>
struct Rounded {
  T value;

  friend Rounded operator-(Rounded x) { return {-x.value}; }
  friend Rounded operator-(Rounded x, Rounded y) { return {x.value - y.value}; }
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
  friend NearOne squared(NearOne x) { NearOne y; y.below = x.below * (T(2.0) - x.below); return y; }
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
  friend Rounded<T> operator+(Leading x, Rounded<T> y) { return {x.high + (x.low + y.value)}; }
  friend Rounded<T> from_square(Leading s, Leading y, T a) {
    const Sum<T> p = two_product(a, y.high);
    return {(s.high * s.high - p.high) + (((s.high + rounded(s)) * s.low - a * y.low) - p.low)};
  }
  friend Leading operator*(Leading x, NearOne<T> y) { return {x.high, x.low - rounded(x) * y.below}; }
  friend Leading operator*(Leading x, T y) { return {x.high * y, x.low * y}; }
  friend Rounded<T> operator*(Leading x, Leading y) { return {rounded(x) * rounded(y)}; }
  friend Rounded<T> operator-(Rounded<T> x, Leading y) { return {x.value - rounded(y)}; }
  
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
  /// (2 + alpha) alpha, or (1 + alpha)^2 from alpha = 1 on.
  template <class Condition>
  static Rough root_argument(T alpha, Condition is_beyond) {
    const Sum<T> s = ordered_sum(select(is_beyond, alpha, T(2.0)), select(is_beyond, T(1.0), alpha));
    const T factor = select(is_beyond, s.high, alpha);
    const Sum<T> p = two_product(s.high, factor);
    return {p.high, p.low + s.low * select(is_beyond, s.high + s.high, alpha)};
  }
  friend Rough operator-(Pi, Rough x) {
    return {T(0x1.921fb54442d18p+1) - x.high, T(0x1.1a62633145c07p-53) - x.low};
  }
  friend Rounded<T> operator+(Rough x, Rough y) {
    return {(x.high + y.high) + (x.low + y.low)};
  }
  friend Rounded<T> operator-(Rough x, Rough y) {
    return {(x.high - y.high) + (x.low - y.low)};
  }
  friend Rough squared(Rough x) {
    const Sum<T> p = two_product(x.high, x.high);
    return {p.high, p.low + (x.high + x.high) * x.low};
  }
  friend Rough quickly_squared(Rough x) {
    return {x.high * x.high, (x.high + x.high) * x.low};
  }
  friend Rough quickly_times(Rough x, T y) {
    return {x.high * y, x.low * y};
  }
  friend Leading<T> operator*(Rough x, Leading<T> y) {
    const Sum<T> p = two_product(x.high, y.high);
    return {p.high, p.low + (x.high * y.low + x.low * rounded(y))};
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
[[gnu::always_inline]] inline Rough<T> reciprocal_square_root(Rough<T> w) {
  const T y = reciprocal_square_root_estimate(w.high);
  const T square = y * y;
  const T e = one_minus_product(w.high, square) - w.low * square;
  const Sum<T> root = ordered_sum(y, y * (e * (T(0.5) + T(0.375) * e)));
  return {root.high, root.low};
}

inline constexpr double rough_arctangent_coefficients[] = {
    -0x1.5555555555555p-4,
    0x1.99999999998a3p-3,
    -0x1.2492492485d7p-3,
    0x1.c71c71bf5b467p-4,
    -0x1.745d1604c964ap-4,
    0x1.3b139224403b2p-4,
    -0x1.110f1c6f22223p-4,
    0x1.e1b6e650573e1p-5,
    -0x1.addc39402eebbp-5,
    0x1.7eec98aa8004ep-5,
    -0x1.47a907b386feep-5,
    0x1.ec8007e521394p-6,
    -0x1.12c36f23202ddp-6,
    0x1.42c8f765a8251p-8,
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
    0x1.5555555555515p-5,
    -0x1.6c16c16bfd02cp-10,
    0x1.a01a0134951b4p-16,
    -0x1.27e43719eaf9fp-22,
    0x1.1da7850842dddp-29,
};

template <class T>
[[gnu::always_inline]] inline Rough<T> arctangent(Rough<T> t) {
  const T z = t.high * t.high;
  const T cube = t.high * z;
  const Sum<T> head = ordered_sum(t.high, T(-0.25) * cube);
  const T rest = cube * two_chains(rough_arctangent_coefficients, z) + t.low * (T(1.0) - T(0.75) * z);
  return Rough<T>::in_order(head.high, head.low + rest);
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
  const Rough<T> s = Rough<T>::in_order(r.high,
                   r.low * top.high + (r.high * z) * two_chains(rough_sine_coefficients, z));
  const Rough<T> c = Rough<T>::in_order(top.high,
                   top.low + (fourth * two_chains(cosine_coefficients, z) - r.high * r.low));
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
  turn.sine = {r.high, r.low + (r.high * z) * two_chains(small_sine_coefficients, z)};
  turn.cosine.below = T(0.5) * z + (r.high * r.low - (z * z) * two_chains(small_cosine_coefficients, z));
  return turn;
}
template <class T>
[[gnu::always_inline]] inline auto sine_cosine_of_small(Tracked<T> x) { return sine_cosine(x); }
template <class T>
[[gnu::always_inline]] inline auto sine_cosine_of_small(Bounded<T> x) { return sine_cosine(x); }
template <class T>
[[gnu::always_inline]] inline auto sine_cosine_of_small(Pair<T> x) { return sine_cosine(x); }

template <class Number> struct Small { using Sine = Number; using Cosine=Number; using Result=Number; using Output=Product<Number>; };
template <class T> struct Small<Rough<T>> { using Sine = Leading<T>; using Cosine=NearOne<T>; using Result=Rounded<T>; using Output=Rounded<T>; };

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
