// SPDX-License-Identifier: MIT
// A float of MPFR's with as many bits as are asked for, and what generated code asks of a number
// type. Bounds are emitted in units; one is 2^-bits. It has some more bits than that, so that an
// operation may round some times.
#pragma once

#include <cfloat>
#include <cmath>
#include <cstdint>

#include <mpfr.h>

#include "magicmass/arithmetic/functions.hpp"
#include "magicmass/arithmetic/rounding_test.hpp"

namespace magicmass::numbers {
static_assert(LDBL_MIN_EXP < -8000, "sizes of error bounds need the exponents of long double");
class MpfrFloat {
public:
  using Size = long double;  // of errors
  using Value = MpfrFloat;
  using Result = double;
  static constexpr bool is_wide = true;
  static inline thread_local long bits = 176;
  static constexpr long spare = 8;
  /// For inputs whose results are computed without rounding: bounds are 0 then.
  static inline thread_local bool is_exact = false;

  MpfrFloat() {
    if (bits + spare <= own_limbs * 64)
      mpfr_custom_init_set(v, MPFR_ZERO_KIND, 0, bits + spare, limbs);
    else
      mpfr_init2(v, bits + spare);
  }
  MpfrFloat(double x) : MpfrFloat() { mpfr_set_d(v, x, MPFR_RNDN); }
  MpfrFloat(const MpfrFloat& x) : MpfrFloat() { mpfr_set(v, x.v, MPFR_RNDN); }
  MpfrFloat& operator=(const MpfrFloat& x) {
    mpfr_set(v, x.v, MPFR_RNDN);
    return *this;
  }
  ~MpfrFloat() {
    if (mpfr_custom_get_significand(v) != limbs) mpfr_clear(v);
  }

  static MpfrFloat whole(std::int64_t n) { return of(mpfr_set_sj, n); }
  static double to_result(const MpfrFloat& x) { return mpfr_get_d(x.v, MPFR_RNDN); }
  static std::int64_t to_whole(const MpfrFloat& x) {
    return sizeof(long) == 8 ? mpfr_get_si(x.v, MPFR_RNDN) : mpfr_get_sj(x.v, MPFR_RNDN);
  }
  static MpfrFloat nearest(const MpfrFloat& x) { return of(mpfr_rint, x.v); }
  static MpfrFloat pi() { return of(mpfr_const_pi); }
  static const MpfrFloat& exact(const MpfrFloat& x) { return x; }
  static MpfrFloat all(double x) { return x; }
  static MpfrFloat two_sum(const MpfrFloat& x, const MpfrFloat& y) { return x + y; }
  static MpfrFloat fast_two_sum(const MpfrFloat& x, const MpfrFloat& y) { return x + y; }
  /// p and q are whole.
  static MpfrFloat rational(double p, double q, double, double) { return over(long(q), p); }
  static MpfrFloat pi_times(double p, double q, double, double) {
    return over(long(q), of(mpfr_mul_si, pi().v, long(p)));
  }
  static MpfrFloat times_sign_of(const MpfrFloat& x, const MpfrFloat& y) {
    return (-y).is_positive() ? -x : x;
  }
  static MpfrFloat turn(const MpfrFloat& n) { return to_whole(n) % 2 == 0 ? 1.0 : -1.0; }
  /// Above |x|, by a factor of 2 at most.
  static Size magnitude_of(const MpfrFloat& x) {
    return std::ldexp(Size(1), static_cast<int>(exponent(x)));
  }
  /// x units are below 2^that.
  static long exponent_of(Size x) { return is_exact ? -(1L << 30) : std::ilogb(x) + 1 - bits; }
  bool is_positive() const { return mpfr_sgn(v) > 0; }
  bool is_zero() const { return mpfr_zero_p(v) != 0; }
  friend MpfrFloat operator-(const MpfrFloat& x) { return of(mpfr_neg, x.v); }
  friend MpfrFloat operator+(const MpfrFloat& x, const MpfrFloat& y) {
    return of(mpfr_add, x.v, y.v);
  }
  friend MpfrFloat operator-(const MpfrFloat& x, const MpfrFloat& y) {
    return of(mpfr_sub, x.v, y.v);
  }
  friend MpfrFloat operator*(const MpfrFloat& x, const MpfrFloat& y) {
    return of(mpfr_mul, x.v, y.v);
  }
  friend MpfrFloat operator/(const MpfrFloat& x, const MpfrFloat& y) {
    return of(mpfr_div, x.v, y.v);
  }
  friend MpfrFloat reciprocal_root(const MpfrFloat& x) { return of(mpfr_rec_sqrt, x.v); }
  friend MpfrFloat scaled(const MpfrFloat& x, double power_of_2) {
    const MpfrFloat y = of(mpfr_mul_2si, x.v, std::ilogb(power_of_2));
    return power_of_2 < 0 ? -y : y;
  }
  friend MpfrFloat near_sum(const MpfrFloat& x, const MpfrFloat& y) { return x + y; }
  friend MpfrFloat cancelling_sum(const MpfrFloat& x, const MpfrFloat& y) { return x + y; }
  friend MpfrFloat times(const MpfrFloat& x, const MpfrFloat& y) { return x * y; }
  friend MpfrFloat quotient(const MpfrFloat& x, const MpfrFloat& y) { return x / y; }
  friend MpfrFloat magnitude(const MpfrFloat& x) { return of(mpfr_abs, x.v); }
  friend const MpfrFloat& leading(const MpfrFloat& x) { return x; }
  /// x^n by squaring, 0 < x <= 1, n >= 0 whole; from 2^-480 down that.
  friend MpfrFloat power(MpfrFloat x, const MpfrFloat& n) {
    MpfrFloat result = 1.0;
    const MpfrFloat least = 0x1p-480;
    for (std::int64_t left = to_whole(n); left > 0; left /= 2) {
      if (left % 2 != 0) result = of(mpfr_max, (result * x).v, least.v);
      x = of(mpfr_max, (x * x).v, least.v);
    }
    return result;
  }
  /// Near 0 a few terms of the series are quicker than MPFR's functions, and within the spare bits.
  template <class Tier>
  friend MpfrFloat arc_tangent(const MpfrFloat& t, const MpfrFloat& z) {
    if (exponent(z) > series_below) return of(mpfr_atan, t.v);
    const auto q = [](auto& x, long k) { return over(2 * k + 1, of(mpfr_mul_si, x.v, 2 * k - 1)); };
    return t * series(z, q);
  }
  template <class Tier>
  friend arithmetic::SineCosine<MpfrFloat> sine_cosine(const MpfrFloat& x) {
    return {of(mpfr_sin, x.v), of(mpfr_cos, x.v)};
  }
  template <class Tier>
  friend arithmetic::SineCosine<MpfrFloat> sine_cosine_small(const MpfrFloat& x) {
    const MpfrFloat square = x * x;
    if (exponent(square) > series_below) return sine_cosine<Tier>(x);
    return {x * series(square, [](auto& y, long k) { return over(2 * k * (2 * k + 1), y); }),
            series(square, [](auto& y, long k) { return over((2 * k - 1) * 2 * k, y); })};
  }
  friend double doubt_of_sign(const MpfrFloat& x, Size error) {
    return x.is_positive() && exponent(x) > exponent_of(error) ? 0.0 : 1.0;
  }
  friend double doubt_of_range(const MpfrFloat& x, double low, double high) {
    return is_above(x, low) && is_above(high, x) ? 0.0 : 1.0;
  }
  friend bool is_above(const MpfrFloat& x, const MpfrFloat& y) {
    return mpfr_greater_p(x.v, y.v) != 0;
  }
  friend arithmetic::Rounded<double> rounding_test(const MpfrFloat& x, Size error) {
    if (exponent(x) > DBL_MIN_EXP &&
        mpfr_can_round(x.v, exponent(x) - exponent_of(error), MPFR_RNDN, MPFR_RNDN, DBL_MANT_DIG))
      return {rounded(x), 0.0};
    const MpfrFloat e = of(mpfr_set_si_2exp, 1, exponent_of(error));
    const double top = rounded(x + e);
    return {top, top == rounded(x - e) ? 0.0 : 1.0};
  }
  friend double rounded(const MpfrFloat& x) { return mpfr_get_d(x.v, MPFR_RNDN); }
  friend long exponent(const MpfrFloat& x) {
    return mpfr_zero_p(x.v) ? -bits - spare : mpfr_get_exp(x.v);
  }

private:
  template <class F, class... Arguments>
  static MpfrFloat of(F f, Arguments... arguments) {
    MpfrFloat r;
    f(r.v, arguments..., MPFR_RNDN);
    return r;
  }
  static MpfrFloat over(long n, const MpfrFloat& x) { return of(mpfr_div_si, x.v, n); }
  static constexpr long series_below = -16;  // where at most bits/16 terms are needed
  /// 1 - z/q(1) + z^2/(q(1) q(2)) - ..., without terms below the spare bits; q(k) >= 1.
  template <class Q>
  static MpfrFloat series(const MpfrFloat& z, Q q) {
    const MpfrFloat one = 1.0;
    MpfrFloat sum = one;
    for (long k = (bits + spare) / -exponent(z); k > 0; --k) {
      const MpfrFloat rest = z * sum;
      sum = one - q(rest, k);
    }
    return sum;
  }
  // The first precision fits in here: memory from the heap would take more time than arithmetic.
  static constexpr long own_limbs = 3;
  mpfr_t v;
  mp_limb_t limbs[own_limbs];
};
}  // namespace magicmass::numbers
