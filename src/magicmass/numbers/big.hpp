// SPDX-License-Identifier: MIT
// Big: what generated code asks of a number type, from the arithmetic of a large float F, of which
// there are two. Bounds are emitted in units; one is 2^-F::bits. F has some more bits than that, so
// that an operation may round some times.
#pragma once

#include <cstdint>

#include "magicmass/arithmetic/functions.hpp"
#include "magicmass/arithmetic/rounding_test.hpp"

namespace magicmass::numbers {
/// S is for sizes of errors. F has + - * / and unary -, F(double), and the functions called here.
template <class F, class S>
class Big {
public:
  using Size = S;
  using Value = F;
  using Result = double;
  static constexpr bool is_wide = true;

  static F all(double x) { return x; }
  static const F& exact(const F& x) { return x; }
  static F two_sum(const F& x, const F& y) { return x + y; }
  static F fast_two_sum(const F& x, const F& y) { return x + y; }
  /// p and q are whole.
  static F rational(double p, double q, double, double) { return F(p) / F(q); }
  static F pi_times(double p, double q, double, double) { return F::pi() * F(p) / F(q); }
  static F times_sign_of(const F& x, const F& y) { return (-y).is_positive() ? -x : x; }

  static F turn(const F& n) { return F::to_whole(n) % 2 == 0 ? 1.0 : -1.0; }
  /// x^n by squaring, 0 < x <= 1, n >= 0 whole; from 2^-480 down that.
  friend F power(F x, const F& n) {
    const auto times_or_least = [](const F& a, const F& b) {
      const F product = a * b;
      return is_above(product, 0x1p-480) ? product : F(0x1p-480);
    };
    F result = 1.0;
    for (std::int64_t left = F::to_whole(n); left > 0; left /= 2) {
      if (left % 2 != 0) result = times_or_least(result, x);
      x = times_or_least(x, x);
    }
    return result;
  }

  friend F near_sum(const F& x, const F& y) { return x + y; }
  friend F cancelling_sum(const F& x, const F& y) { return x + y; }
  friend F times(const F& x, const F& y) { return x * y; }
  friend F quotient(const F& x, const F& y) { return x / y; }
  friend F magnitude(const F& x) { return (-x).is_positive() ? -x : x; }
  friend const F& leading(const F& x) { return x; }

  /// Near 0 a few terms of the series are sooner than functions of F, and within the spare bits.
  template <class Tier>
  friend F arc_tangent(const F& t, const F& z) {
    if constexpr (requires { F::arc_tangent(t); }) {
      if (exponent(z) > series_below) return F::arc_tangent(t);
    }
    return t * series(z, [](long k) { return F(double(2 * k - 1)) * F::inverse(2 * k + 1); });
  }
  template <class Tier>
  friend arithmetic::SineCosine<F> sine_cosine(const F& x) {
    return F::sine_cosine(x);
  }
  template <class Tier>
  friend arithmetic::SineCosine<F> sine_cosine_small(const F& x) {
    const F square = x * x;
    if constexpr (requires { F::sine_cosine(x); }) {
      if (exponent(square) > series_below) return F::sine_cosine(x);
    }
    return {x * series(square, [](long k) { return F::inverse(2 * k * (2 * k + 1)); }),
            series(square, [](long k) { return F::inverse((2 * k - 1) * 2 * k); })};
  }

  friend double doubt_of_sign(const F& x, Size error) {
    return is_above(x, F::in_units(error)) ? 0.0 : 1.0;
  }
  friend double doubt_of_range(const F& x, double low, double high) {
    return is_above(x, low) && is_above(high, x) ? 0.0 : 1.0;
  }

private:
  static constexpr long series_below = -16;  // where at most bits/16 terms are needed
  /// 1 - z r_1 + z^2 r_1 r_2 - ..., without terms below the spare bits; r_k = ratio(k) <= 1.
  template <class R>
  static F series(const F& z, R ratio) {
    F term = -z * ratio(1);
    F sum = F(1.0) + term;
    for (long k = 2; exponent(term) + exponent(z) > -F::bits - F::spare; ++k) {
      term = -term * z * ratio(k);
      sum = sum + term;
    }
    return sum;
  }
};
}  // namespace magicmass::numbers
