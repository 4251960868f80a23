// SPDX-License-Identifier: MIT
#pragma once

#include "magicmass/arithmetic/arctangent.hpp"
#include "magicmass/arithmetic/product.hpp"
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

[[gnu::always_inline]] inline double leading_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::int64_t>(x) & -(std::int64_t{1} << 27U));
}
template <int N>
[[gnu::always_inline]] inline Lanes<N> leading_half(Lanes<N> x) {
  using Bits = typename Lanes<N>::Mask;
  return std::bit_cast<typename Lanes<N>::Doubles>(std::bit_cast<Bits>(x.v) &
                                                   (Bits{} - (std::int64_t{1} << 27U)));
}

template <class T>
struct Rounded {
  T value;
  friend Rounded operator+(Rounded x, Rounded y) { return {x.value + y.value}; }
  friend Rounded operator-(Rounded x, Rounded y) { return {x.value - y.value}; }
  friend Rounded operator*(Rounded x, T y) { return {x.value * y}; }
  friend Rounded scaled(Rounded x, T power_of_two) { return {x.value * power_of_two}; }
  friend T rounded(Rounded x) { return x.value; }
};

/// 1 - below.
template <class T>
struct NearOne {
  T below;
  NearOne() = default;
  explicit NearOne(T exact) : below(T(1.0) - exact) {}
  friend NearOne operator*(NearOne x, NearOne y) { NearOne z; z.below = x.below + (y.below - x.below * y.below); return z; }
  template <class Condition>
  friend NearOne select(Condition condition, NearOne yes, NearOne no) {
    NearOne result;
    result.below = select(condition, yes.below, no.below);
    return result;
  }
};

/// high + low, high exact product: sums are rounded
template <class T>
struct Wide {
  T high, low;
  friend Rounded<T> operator+(Wide x, Wide y) { return {(x.high + y.high) + (x.low + y.low)}; }
  friend Rounded<T> operator-(Wide x, Wide y) { return {(x.high - y.high) + (x.low - y.low)}; }
  friend Wide operator*(Wide x, NearOne<T> y) { return {x.high, x.low - rounded(x) * y.below}; }
  friend Wide operator*(Wide x, T y) { return {x.high * y, x.low * y}; }
  friend T rounded(Wide x) { return x.high + x.low; }
};

/// lead of 26 bits, rest
template <class T>
struct Cut {
  T lead, rest;
  Cut() = default;
  Cut(T l, T r) : lead(l), rest(r) {}
  template <class Condition>
  friend Cut select(Condition condition, Cut yes, Cut no) {
    return {select(condition, yes.lead, no.lead), select(condition, yes.rest, no.rest)};
  }
  friend T rounded(Cut x) { return x.lead + x.rest; }
  friend Cut operator*(Cut x, NearOne<T> y) { return {x.lead, x.rest - rounded(x) * y.below}; }
  friend Wide<T> operator*(Cut x, Cut y) {
    return {x.lead * y.lead, x.rest * y.lead + rounded(x) * y.rest};
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
  Rough(Cut<T> x) : high(x.lead), low(x.rest) {}
  operator Wide<T>() const { return {high, low}; }

  struct HalfPi {};
  static HalfPi half_pi_() { return {}; }
  friend Rough operator-(HalfPi, Rough x) { return {T(half_pi[0]) - x.high, T(half_pi[1]) - x.low}; }

  static Rough in_order(T x, T y) {
    const Sum<T> s = ordered_sum(x, y);
    return {s.high, s.low};
  }
  friend Cut<T> cut(Rough x) {
    const T lead = leading_half(x.high);
    return {lead, (x.high - lead) + x.low};
  }
  /// (2 + alpha) alpha, or (1 + alpha)^2 from alpha = 1 on.
  template <class Condition>
  static Rough root_argument(T alpha, Condition is_beyond) {
    const Sum<T> s = ordered_sum(select(is_beyond, alpha, T(2.0)), select(is_beyond, T(1.0), alpha));
    const T factor = alpha + where(is_beyond, T(1.0));
    const Sum<T> p = two_product(s.high, factor);
    return {p.high, p.low + s.low * (factor + where(is_beyond, s.high))};
  }
  friend Rough operator*(Rough x, Rough y) {
    const Sum<T> p = two_product(x.high, y.high);
    return {p.high, p.low + (x.high * y.low + x.low * rounded(y))};
  }
  friend Rough operator*(Rough x, T y) {
    const Sum<T> p = two_product(x.high, y);
    return {p.high, p.low + x.low * y};
  }
  friend Rough squared(Rough x) {
    const Sum<T> p = two_product(x.high, x.high);
    return {p.high, p.low + (x.high + rounded(x)) * x.low};
  }
  friend Rough scaled(Rough x, T power_of_two) {
    return {x.high * power_of_two, x.low * power_of_two};
  }
  template <class Condition>
  friend Rough select(Condition condition, Rough yes, Rough no) {
    return {select(condition, yes.high, no.high), select(condition, yes.low, no.low)};
  }
  friend T rounded(Rough x) { return x.high + x.low; }
};

template <class T>
[[gnu::always_inline]] inline Rough<T> operator*(Cut<T> x, T y) {
  const T lead = leading_half(y);
  return Rough<T>::in_order(x.lead * lead, x.lead * (y - lead) + x.rest * y);
}
template <class T>
[[gnu::always_inline]] inline Rough<T> operator*(Cut<T> x, Rough<T> y) {
  return Rough<T>(x) * y;
}

template <class T>
[[gnu::always_inline]] inline Cut<T> reciprocal_square_root(Rough<T> w) {
  const T y = reciprocal_square_root_estimate(w.high);
  const T square = y * y;
  const T e = one_minus_product(w.high, square) - w.low * square;
  return {y, y * (e * (T(0.5) + T(0.375) * e))};
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
    -0x1.5555555555555p-5,
    0x1.11111111110d6p-7,
    -0x1.a01a01a00e3e7p-13,
    0x1.71de3a4530ba6p-19,
    -0x1.ae644047f8a15p-26,
    0x1.61151ce475fe3p-33,
    -0x1.a521d2f85bb7bp-41,
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
  return {head.high, head.low + rest};
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
  const T cube = r.high * z;
  const Sum<T> head = ordered_sum(r.high, T(-0.125) * cube);
  const Rough<T> s = Rough<T>::in_order(head.high,
                   head.low + (r.low * top.high + cube * two_chains(rough_sine_coefficients, z)));
  const Rough<T> c{top.high,
                   top.low + (fourth * two_chains(cosine_coefficients, z) - (r.high * r.low + T(0.5) * product_error(r.high, r.high, z)))};
  return {select(is_turned, c, s), select(is_turned, s, c)};
}

template <class T>
struct SmallTurn {
  Cut<T> sine;
  NearOne<T> cosine;
};

template <class T>
[[gnu::always_inline]] inline SmallTurn<T> sine_cosine_of_small(Rough<T> x) {
  const Sum<T> r = ordered_sum(x.high, x.low);
  const T z = r.high * r.high;
  const T lead = leading_half(r.high);
  SmallTurn<T> turn;
  turn.sine = {lead, (r.high - lead) + (r.low + (r.high * z) * two_chains(small_sine_coefficients, z))};
  turn.cosine.below = T(0.5) * z + (r.high * r.low - (z * z) * two_chains(small_cosine_coefficients, z));
  return turn;
}
template <class T>
[[gnu::always_inline]] inline auto sine_cosine_of_small(Tracked<T> x) { return sine_cosine(x); }
template <class T>
[[gnu::always_inline]] inline auto sine_cosine_of_small(Bounded<T> x) { return sine_cosine(x); }
template <class T>
[[gnu::always_inline]] inline auto sine_cosine_of_small(Pair<T> x) { return sine_cosine(x); }

template <class Number> struct Small { using Root = Number; using Sine = Number; using Cosine=Number; using Result=Number; using Output=Product<Number>; };
template <class T> struct Small<Rough<T>> { using Root = Cut<T>; using Sine = Cut<T>; using Cosine=NearOne<T>; using Result=Rounded<T>; using Output=Rounded<T>; };

}  // namespace MAGICMASS_TARGET
}  // namespace magicmass::arithmetic
