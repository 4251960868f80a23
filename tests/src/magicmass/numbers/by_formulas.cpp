// SPDX-License-Identifier: GPL-2.0-or-later
#include "src/magicmass/numbers/by_formulas.hpp"

#include <algorithm>
#include <cmath>

#include <mpfr.h>

namespace magicmass::testing {
namespace {
/// An MPFR number of the precision of its time.
class Real {
public:
  Real(double x = 0) {
    mpfr_init(v);
    mpfr_set_d(v, x, MPFR_RNDN);
  }
  Real(const Real& x) : Real() { mpfr_set(v, x.v, MPFR_RNDN); }
  Real& operator=(const Real& x) {
    mpfr_set(v, x.v, MPFR_RNDN);
    return *this;
  }
  ~Real() { mpfr_clear(v); }
  friend Real operator+(const Real& x, const Real& y) { return of(mpfr_add, x, y); }
  friend Real operator-(const Real& x, const Real& y) { return of(mpfr_sub, x, y); }
  friend Real operator*(const Real& x, const Real& y) { return of(mpfr_mul, x, y); }
  friend Real operator/(const Real& x, const Real& y) { return of(mpfr_div, x, y); }
  static Real of(int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), const Real& x) {
    Real r;
    f(r.v, x.v, MPFR_RNDN);
    return r;
  }
  static Real of(int (*f)(mpfr_ptr, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t), const Real& x,
                 const Real& y) {
    Real r;
    f(r.v, x.v, y.v, MPFR_RNDN);
    return r;
  }
  mpfr_t v;
};
Real whole(std::int64_t n) {
  Real r;
  mpfr_set_sj(r.v, n, MPFR_RNDN);
  return r;
}

/// h = psi/2 and what the four velocities share.
class Formulas {
public:
  explicit Formulas(double x) : precision(set_precision(x)) {
    alpha = x;
    const Real tangent = Real::of(mpfr_sqrt, alpha * (alpha + 2));
    h = Real::of(mpfr_atan, tangent);
    V = Real(1) / (alpha + 2);
    per_half = Real(1) / Real::of(mpfr_sin, h * 0.5);
    // Angles up to 4 pi, each within some units of 2^-precision; 1 + alpha <= 2^11.
    error = per_half + 0x1p12;
    mpfr_mul_2si(error.v, error.v, 8 - precision, MPFR_RNDU);
  }
  Real a(const Real& n) const { return V * (Real(1) + (alpha + 1) * cosine(n + n)); }
  Real b(const Real& n) const { return V * (Real(1) - (alpha + 1) * cosine(n + n + 1)); }
  Real c(const Real& n) const { return V * (Real(1) + per_half * sine(n + n - 0.5)); }
  Real c_prime(const Real& n) const { return V * (Real(1) - per_half * sine(n + n + 0.5)); }
  /// x rounded; `is_certain` is cleared where the error might change it.
  double rounded(const Real& x, const Real& off) {
    const double low = mpfr_get_d((x - off).v, MPFR_RNDN);
    const double high = mpfr_get_d((x + off).v, MPFR_RNDN);
    is_certain = is_certain && low == high;
    return low;
  }
  double rounded(const Real& x) { return rounded(x, error); }

  long precision;  // first: the others are made with it
  Real alpha, h, V, per_half, error;
  bool is_certain = true;

private:
  /// Results are as small as alpha^(3/2) against terms as large as alpha^(-1/2).
  static long set_precision(double alpha) {
    const long bits = 160 - 2 * std::min(0, std::ilogb(alpha));
    mpfr_set_default_prec(bits);
    return bits;
  }
  Real cosine(const Real& k) const { return Real::of(mpfr_cos, k * h); }
  Real sine(const Real& k) const { return Real::of(mpfr_sin, k * h); }
};
}  // namespace

std::optional<Velocities> velocities_by_formulas(double alpha, std::int64_t n) {
  Formulas f(alpha);
  const Real k = whole(n);
  const Velocities v{f.rounded(f.a(k)), f.rounded(f.b(k)), f.rounded(f.c(k)),
                     f.rounded(f.c_prime(k))};
  return f.is_certain ? std::optional(v) : std::nullopt;
}
std::optional<Terminal> terminal_by_formulas(double alpha) {
  Formulas f(alpha);
  Real pi;
  mpfr_const_pi(pi.v, MPFR_RNDN);
  const Real last = pi / f.h;  // N = ceil(pi/h) - 1
  Real off = last;
  mpfr_mul_2si(off.v, off.v, 4 - f.precision, MPFR_RNDU);
  const Real low = last - off;
  const Real high = last + off;
  const std::intmax_t N = mpfr_get_sj(low.v, MPFR_RNDU) - 1;
  if (mpfr_get_sj(high.v, MPFR_RNDU) - 1 != N) return std::nullopt;
  const Counts counts{N / 2 + N % 2, N / 2};
  const Real b = f.b(whole(counts.N_B));
  const Terminal t{counts, f.rounded(f.a(whole(counts.N_A))), f.rounded(b),
                   f.rounded(N % 2 == 1 ? f.c(whole(counts.N_A)) : f.c_prime(whole(counts.N_B))),
                   f.rounded(b * b, f.error * 3)};
  return f.is_certain ? std::optional(t) : std::nullopt;
}
}  // namespace magicmass::testing
