// SPDX-License-Identifier: MIT
// A float of MPFR's with as many bits as are asked for.
#pragma once

#include <cfloat>
#include <cmath>
#include <cstdint>

#include <mpfr.h>

#include "magicmass/numbers/big.hpp"

namespace magicmass::numbers {
static_assert(LDBL_MIN_EXP < -8000, "sizes of error bounds need the exponents of long double");
class MpfrFloat : public Big<MpfrFloat, long double> {
public:
  static inline thread_local long bits = 182;
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
  static std::int64_t to_whole(const MpfrFloat& x) { return mpfr_get_sj(x.v, MPFR_RNDN); }
  static MpfrFloat nearest(const MpfrFloat& x) { return of(mpfr_rint, x.v); }
  static MpfrFloat pi() { return of(mpfr_const_pi); }
  static MpfrFloat inverse(long n) { return of(mpfr_si_div, 1L, MpfrFloat(double(n)).v); }
  static Size magnitude_of(const MpfrFloat& x) {
    long exponent = 0;
    const double part = mpfr_get_d_2exp(&exponent, x.v, MPFR_RNDN);
    return std::ldexp(static_cast<Size>(std::fabs(part)), static_cast<int>(exponent));
  }
  static MpfrFloat in_units(Size x) {
    if (is_exact) return 0.0;
    int exponent = 0;
    const MpfrFloat part = static_cast<double>(std::frexp(x, &exponent));
    return of(mpfr_mul_2si, part.v, exponent - bits);
  }
  static MpfrFloat arc_tangent(const MpfrFloat& x) { return of(mpfr_atan, x.v); }
  static arithmetic::SineCosine<MpfrFloat> sine_cosine(const MpfrFloat& x) {
    return {of(mpfr_sin, x.v), of(mpfr_cos, x.v)};
  }

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
  friend MpfrFloat scaled(const MpfrFloat& x, double power_of_2) { return x * power_of_2; }
  friend bool is_above(const MpfrFloat& x, const MpfrFloat& y) {
    return mpfr_greater_p(x.v, y.v) != 0;
  }
  friend arithmetic::Rounded<double> rounding_test(const MpfrFloat& x, Size error) {
    const MpfrFloat e = in_units(error);
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
  // The first precision fits in here: memory from the heap would take more time than arithmetic.
  static constexpr long own_limbs = 3;
  mpfr_t v;
  mp_limb_t limbs[own_limbs];
};
}  // namespace magicmass::numbers
