// SPDX-License-Identifier: MIT
// Big: the number type behind the last rounding test, MPFR's. It answers what generated code asks
// of a number type. Bounds are emitted in units; one is 2^-bits.
#pragma once

#include <cfloat>
#include <cmath>
#include <cstdint>

#include <mpfr.h>

#include "magicmass/arithmetic/functions.hpp"
#include "magicmass/arithmetic/rounding_test.hpp"

namespace magicmass::numbers {
static_assert(LDBL_MIN_EXP < -8000, "sizes of error bounds need the exponents of long double");
class Big {
public:
  using Value = Big;
  using Result = double;
  /// Numbers have `spare` more bits than the unit says: an operation may round some times.
  static inline thread_local long bits = 182;
  static constexpr long spare = 8;
  /// For inputs whose results are computed without rounding: bounds are 0 then.
  static inline thread_local bool is_exact = false;

  Big() {
    if (bits + spare <= own_limbs * 64) {
      mpfr_custom_init_set(v, MPFR_ZERO_KIND, 0, bits + spare, limbs);
    } else {
      mpfr_init2(v, bits + spare);
    }
  }
  Big(double x) : Big() { mpfr_set_d(v, x, MPFR_RNDN); }
  Big(const Big& x) : Big() { mpfr_set(v, x.v, MPFR_RNDN); }
  Big& operator=(const Big& x) {
    mpfr_set(v, x.v, MPFR_RNDN);
    return *this;
  }
  ~Big() {
    if (mpfr_custom_get_significand(v) != limbs) mpfr_clear(v);
  }

  static Big all(double x) { return x; }
  static Big whole(std::int64_t n) {
    return of([&](mpfr_ptr r) { mpfr_set_sj(r, n, MPFR_RNDN); });
  }
  static std::int64_t to_whole(const Big& x) { return mpfr_get_sj(x.v, MPFR_RNDN); }
  static const Big& exact(const Big& x) { return x; }
  static Big two_sum(const Big& x, const Big& y) { return x + y; }
  static Big fast_two_sum(const Big& x, const Big& y) { return x + y; }
  /// p and q are whole.
  static Big rational(double p, double q, double, double) {
    Big r = p;
    mpfr_div_ui(r.v, r.v, static_cast<unsigned long>(q), MPFR_RNDN);
    return r;
  }
  static Big pi_times(double p, double q, double, double) {
    return of([&](mpfr_ptr r) {
      mpfr_const_pi(r, MPFR_RNDN);
      mpfr_mul_ui(r, r, static_cast<unsigned long>(p), MPFR_RNDN);
      mpfr_div_ui(r, r, static_cast<unsigned long>(q), MPFR_RNDN);
    });
  }
  static Big nearest(const Big& x) {
    return of([&](mpfr_ptr r) { mpfr_rint(r, x.v, MPFR_RNDN); });
  }
  /// Sizes in error bounds: 53 bits will do, but not the exponents of doubles.
  static long double magnitude_of(const Big& x) {
    long exponent = 0;
    const double part = mpfr_get_d_2exp(&exponent, x.v, MPFR_RNDN);
    return std::ldexp(static_cast<long double>(std::fabs(part)), static_cast<int>(exponent));
  }
  static Big times_sign_of(const Big& x, const Big& y) { return mpfr_signbit(y.v) ? -x : x; }

  friend Big operator-(const Big& x) {
    return of([&](mpfr_ptr r) { mpfr_neg(r, x.v, MPFR_RNDN); });
  }
  friend Big operator+(const Big& x, const Big& y) {
    return of([&](mpfr_ptr r) { mpfr_add(r, x.v, y.v, MPFR_RNDN); });
  }
  friend Big operator-(const Big& x, const Big& y) {
    return of([&](mpfr_ptr r) { mpfr_sub(r, x.v, y.v, MPFR_RNDN); });
  }
  friend Big operator*(const Big& x, const Big& y) {
    return of([&](mpfr_ptr r) { mpfr_mul(r, x.v, y.v, MPFR_RNDN); });
  }
  friend Big operator*(const Big& x, double y) {
    return of([&](mpfr_ptr r) { mpfr_mul_d(r, x.v, y, MPFR_RNDN); });
  }
  friend Big operator/(const Big& x, const Big& y) {
    return of([&](mpfr_ptr r) { mpfr_div(r, x.v, y.v, MPFR_RNDN); });
  }
  friend Big near_sum(const Big& x, const Big& y) { return x + y; }
  friend Big cancelling_sum(const Big& x, const Big& y) { return x + y; }
  friend Big times(const Big& x, const Big& y) { return x * y; }
  friend Big scaled(const Big& x, double power_of_2) {
    int exponent = 0;
    const bool is_negative = std::frexp(power_of_2, &exponent) < 0;
    Big r = of([&](mpfr_ptr y) { mpfr_mul_2si(y, x.v, exponent - 1, MPFR_RNDN); });
    if (is_negative) mpfr_neg(r.v, r.v, MPFR_RNDN);
    return r;
  }
  friend Big quotient(const Big& x, const Big& y) { return x / y; }
  friend Big reciprocal_root(const Big& x) {
    return of([&](mpfr_ptr r) { mpfr_rec_sqrt(r, x.v, MPFR_RNDN); });
  }
  friend Big magnitude(const Big& x) {
    return of([&](mpfr_ptr r) { mpfr_abs(r, x.v, MPFR_RNDN); });
  }
  friend const Big& leading(const Big& x) { return x; }
  friend double rounded(const Big& x) { return mpfr_get_d(x.v, MPFR_RNDN); }
  friend bool is_above(const Big& x, const Big& y) { return mpfr_greater_p(x.v, y.v) != 0; }

  /// Near 0 a few terms of the series are sooner than MPFR's functions, and within the spare bits.
  template <class Tier>
  friend Big arc_tangent(const Big& t, const Big& z) {
    if (exponent(z) > series_below) {
      return of([&](mpfr_ptr r) { mpfr_atan(r, t.v, MPFR_RNDN); });
    }
    return t * series(z, [](long k) { return Step{2 * k - 1, 2 * k + 1}; });
  }
  template <class Tier>
  friend arithmetic::SineCosine<Big> sine_cosine(const Big& x) {
    arithmetic::SineCosine<Big> r;
    mpfr_sin_cos(r.sine.v, r.cosine.v, x.v, MPFR_RNDN);
    return r;
  }
  template <class Tier>
  friend arithmetic::SineCosine<Big> sine_cosine_small(const Big& x) {
    const Big square = x * x;
    if (exponent(square) > series_below) return sine_cosine<Tier>(x);
    return {x * series(square,
                       [](long k) {
                         return Step{1, 2 * k * (2 * k + 1)};
                       }),
            series(square, [](long k) {
              return Step{1, (2 * k - 1) * 2 * k};
            })};
  }

  friend arithmetic::Rounded<double> rounding_test(const Big& p, long double error) {
    const Big e = in_units(error);
    const double top = rounded(p + e);
    return {top, top == rounded(p - e) ? 0.0 : 1.0};
  }
  friend double doubt_of_sign(const Big& x, long double error) {
    return is_above(x, in_units(error)) ? 0.0 : 1.0;
  }
  friend double doubt_of_range(const Big& x, double low, double high) {
    return is_above(x, low) && is_above(high, x) ? 0.0 : 1.0;
  }

private:
  static constexpr long series_below = -16;  // where at most bits/16 terms are needed
  struct Step {
    long numerator, denominator;
  };
  static long exponent(const Big& x) { return mpfr_zero_p(x.v) ? -bits : mpfr_get_exp(x.v); }
  /// 1 - z r_1 + z^2 r_1 r_2 - ..., until a term is below a unit of spare bits; r_k = step(k) <= 1.
  template <class F>
  static Big series(const Big& z, F step) {
    Big sum = 1.0;
    Big term = 1.0;
    for (long k = 1; exponent(term) > -bits - spare; ++k) {
      const Step r = step(k);
      mpfr_mul(term.v, term.v, z.v, MPFR_RNDN);
      if (r.numerator != 1) mpfr_mul_si(term.v, term.v, r.numerator, MPFR_RNDN);
      mpfr_div_si(term.v, term.v, -r.denominator, MPFR_RNDN);
      mpfr_add(sum.v, sum.v, term.v, MPFR_RNDN);
    }
    return sum;
  }
  template <class F>
  static Big of(F f) {
    Big r;
    f(r.v);
    return r;
  }
  static Big in_units(long double x) {
    if (is_exact) return 0.0;
    int exponent = 0;
    Big r = static_cast<double>(std::frexp(x, &exponent));
    mpfr_mul_2si(r.v, r.v, exponent - bits, MPFR_RNDN);
    return r;
  }
  // The first precision fits in here: memory from the heap would take more time than arithmetic.
  static constexpr long own_limbs = 3;
  mpfr_t v;
  mp_limb_t limbs[own_limbs];
};
}  // namespace magicmass::numbers
