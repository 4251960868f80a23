// SPDX-License-Identifier: GPL-2.0-or-later
// A cheaper certified route than the oracle's, for millions of rows: the paper's sums of sines and
// cosines, typed in, on CLN's floats with a bound of their error. The product's evaluators are
// products of other angles. nullopt: not certain, ask the oracle.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include <cln/float.h>
#include <cln/real.h>

#include "magicmass/numbers/values.hpp"
#include "magicmass/oracle/rational.hpp"

namespace magicmass::testing {
/// h = psi/2 and what the four velocities share.
class Formulas {
public:
  using Real = cln::cl_R;
  /// Results are as small as alpha^(3/2) against terms as large as alpha^(-1/2).
  explicit Formulas(double x)
      : precision(160 - 2 * std::min(0, std::ilogb(x))),
        alpha(cln::cl_float(oracle::exact(x), format())),
        h(cln::atan(cln::sqrt(alpha * (alpha + 2)))),
        V(1 / (alpha + 2)),
        per_half(1 / cln::sin(h / 2)),
        // Angles up to 4 pi, each within some units of 2^-precision; 1 + alpha <= 2^11.
        error(cln::scale_float(cln::cl_float(per_half + 4096), 8 - precision)) {}
  cln::float_format_t format() const { return cln::float_format_t(precision); }
  Real a(const Real& n) const { return V * (1 + (alpha + 1) * cln::cos(2 * n * h)); }
  Real b(const Real& n) const { return V * (1 - (alpha + 1) * cln::cos((2 * n + 1) * h)); }
  Real c(const Real& n) const { return V * (1 + per_half * cln::sin((2 * n - half) * h)); }
  Real c_prime(const Real& n) const { return V * (1 - per_half * cln::sin((2 * n + half) * h)); }
  /// x rounded; `is_certain` is cleared where the error might change it.
  double rounded(const Real& x, const Real& off) {
    const double low = oracle::nearest(cln::rational(x - off));
    is_certain = is_certain && low == oracle::nearest(cln::rational(x + off));
    return low;
  }
  double rounded(const Real& x) { return rounded(x, error); }

  int precision;  // first: the others are made with it
  Real half = cln::cl_RA(1) / 2;
  Real alpha, h, V, per_half, error;
  bool is_certain = true;
};

/// alpha <= 2^10, 1 <= n <= N_A.
inline std::optional<Velocities> velocities_by_formulas(double alpha, std::int64_t n) {
  Formulas f(alpha);
  const Velocities v{f.rounded(f.a(n)), f.rounded(f.b(n)), f.rounded(f.c(n)),
                     f.rounded(f.c_prime(n))};
  return f.is_certain ? std::optional(v) : std::nullopt;
}
/// alpha <= 2^10, N_A + N_B < 2^63.
inline std::optional<Terminal> terminal_by_formulas(double alpha) {
  Formulas f(alpha);
  const Formulas::Real last = cln::pi(f.format()) / f.h;  // N = ceil(pi/h) - 1
  const Formulas::Real off = cln::scale_float(cln::cl_float(last), 4 - f.precision);
  const cln::cl_I most = cln::ceiling1(last - off) - 1;
  if (cln::ceiling1(last + off) - 1 != most) return std::nullopt;
  const std::int64_t N = cln::cl_I_to_long(most);
  const Counts counts{N / 2 + N % 2, N / 2};
  const Formulas::Real b = f.b(counts.N_B);
  const Terminal t{counts, f.rounded(f.a(counts.N_A)), f.rounded(b),
                   f.rounded(N % 2 == 1 ? f.c(counts.N_A) : f.c_prime(counts.N_B)),
                   f.rounded(b * b, f.error * 3)};
  return f.is_certain ? std::optional(t) : std::nullopt;
}
}  // namespace magicmass::testing
