// SPDX-License-Identifier: GPL-2.0-or-later
// Intervals of exact rationals, rounded outwards, for the independent checker: CLN's functions,
// nothing of the generator.
#pragma once

#include <stdexcept>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/rational.h>
#include <cln/real.h>

namespace test {
using cln::cl_RA;
constexpr int bits = 240;

/// f(x) from CLN, to a few units of 2^-249 of it.
using RealFunction = const cln::cl_R (*)(const cln::cl_R&);
inline cl_RA by_float(RealFunction f, const cl_RA& x) {
  return cln::rational(f(cln::cl_float(x, cln::float_format(75))));
}

struct Enclosure {
  cl_RA low, high;
};
inline cl_RA largest(const Enclosure& x) { return cln::max(cln::abs(x.low), cln::abs(x.high)); }
inline double size(const Enclosure& x) { return cln::double_approx(largest(x)); }
/// To numbers of at most `bits` binary places beyond their size: outwards.
inline Enclosure outward(const cl_RA& low, const cl_RA& high) {
  const cl_RA size = largest({low, high});
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
/// Of a function whose slope is at most `slope` on x.
inline Enclosure of_function(RealFunction f, const Enclosure& x, const cl_RA& slope) {
  const cl_RA y = by_float(f, x.low);
  const cl_RA off = slope * (x.high - x.low) + cln::abs(y) * cln::expt(cl_RA(2), -bits);
  return outward(y - off, y + off);
}
}  // namespace test
