// SPDX-License-Identifier: GPL-2.0-or-later
// Intervals of exact rationals, rounded outwards, for the independent checker: series with their
// remainders, nothing of the generator.
#pragma once

#include <cmath>
#include <stdexcept>

#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

namespace test {
using cln::cl_I;
using cln::cl_RA;
constexpr int bits = 240;

struct Enclosure {
  cl_RA low, high;
};
/// To numbers of at most `bits` binary places beyond their size: outwards.
inline Enclosure outward(const cl_RA& low, const cl_RA& high) {
  const cl_RA size = cln::max(cln::abs(low), cln::abs(high));
  if (cln::zerop(size)) return {0, 0};
  const long length = long(cln::integer_length(cln::numerator(size))) -
                      long(cln::integer_length(cln::denominator(size)));
  const cl_RA unit = cln::expt(cl_RA(2), int(length) - bits);
  return {cln::floor1(low / unit) * unit, cln::ceiling1(high / unit) * unit};
}
inline Enclosure operator+(const Enclosure& x, const Enclosure& y) {
  return outward(x.low + y.low, x.high + y.high);
}
inline Enclosure operator-(const Enclosure& x) { return {-x.high, -x.low}; }
inline Enclosure operator*(const Enclosure& x, const Enclosure& y) {
  const cl_RA p = x.low * y.low, q = x.low * y.high, r = x.high * y.low, s = x.high * y.high;
  return outward(cln::min(cln::min(p, q), cln::min(r, s)),
                 cln::max(cln::max(p, q), cln::max(r, s)));
}
inline Enclosure inverse(const Enclosure& x) {
  if (x.low <= 0 && x.high >= 0) throw std::domain_error("1/0");
  return outward(1 / x.high, 1 / x.low);
}
inline Enclosure magnitude(const Enclosure& x) {
  if (x.low >= 0) return x;
  return x.high <= 0 ? -x : Enclosure{0, cln::max(-x.low, x.high)};
}
inline Enclosure root(const Enclosure& x) {
  const long length = long(cln::integer_length(cln::numerator(x.high))) -
                      long(cln::integer_length(cln::denominator(x.high)));
  const cl_RA unit = cln::expt(cl_RA(2), int((length / 2) - bits));
  cl_I low, high;
  cln::isqrt(cln::floor1(x.low / (unit * unit)), &low);
  cln::isqrt(cln::ceiling1(x.high / (unit * unit)), &high);
  return {low * unit, (high + 1) * unit};
}
/// first - first*z*ratio(1) + ...: terms fall and signs change, so that the rest is below the last.
template <class Ratio>
Enclosure alternating(Enclosure first, const Enclosure& z, const Ratio& ratio) {
  const cl_RA small = cln::expt(cl_RA(2), -bits) * cln::max(cln::abs(first.low), first.high);
  Enclosure sum = first;
  Enclosure term = first;
  for (int k = 1; k < 400; ++k) {
    term = -(term * z * Enclosure{ratio(k), ratio(k)});
    sum = sum + term;
    const cl_RA size = cln::max(cln::abs(term.low), cln::abs(term.high));
    if (k > 6 && size < small) return outward(sum.low - size, sum.high + size);
  }
  throw std::domain_error("a series that is not done after 400 terms");
}
/// |x| <= 3
inline Enclosure sine(const Enclosure& x) {
  if (cln::zerop(x.low) && cln::zerop(x.high)) return x;
  return alternating(x, x * x, [](int k) { return cl_RA(1) / (2 * k * (2 * k + 1)); });
}
inline Enclosure cosine(const Enclosure& x) {
  return alternating({1, 1}, x * x, [](int k) { return cl_RA(1) / (2 * k * (2 * k - 1)); });
}
/// 0 <= x <= 0.7
inline Enclosure arc_tangent(const Enclosure& x) {
  return alternating(x, x * x, [](int k) { return cl_RA(2 * k - 1) / (2 * k + 1); });
}
inline const Enclosure& pi() {
  const auto of_inverse = [](int n) { return arc_tangent(outward(cl_RA(1) / n, cl_RA(1) / n)); };
  static const Enclosure value =
      Enclosure{16, 16} * of_inverse(5) + Enclosure{-4, -4} * of_inverse(239);
  return value;
}
inline double size(const Enclosure& x) {
  return cln::double_approx(cln::max(cln::abs(x.low), cln::abs(x.high)));
}
}  // namespace test
