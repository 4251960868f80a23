// SPDX-License-Identifier: GPL-2.0-or-later
// A double that knows which roundings it has come through: how much each counts in it, to first
// order. The runtime's own operations run on it, so their roundings are counted by nobody.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "codegen/exact.hpp"
#include "magicmass/arithmetic/functions.hpp"

namespace test {
struct Rounding {
  double most;
  double here;  // what it is with these operands
};
inline std::vector<Rounding> roundings;

struct Traced {
  double value = 0;
  std::vector<long double> slopes = {};  // by rounding

  Traced() = default;
  Traced(double x) : value(x) {}
  /// The sum of what roundings from `from` on may do, each at its most; `here`: what they do here.
  /// Slopes that a step of Newton's makes small are of second order.
  double worst(std::size_t from = 0) const {
    long double sum = 0;
    for (std::size_t k = from; k < slopes.size(); ++k)
      sum += std::fabs(slope(k)) * roundings[k].most;
    return double(sum);
  }
  double here(std::size_t from) const {
    long double sum = 0;
    for (std::size_t k = from; k < slopes.size(); ++k) sum += slope(k) * roundings[k].here;
    return double(sum);
  }
  long double slope(std::size_t k) const { return std::fabs(slopes[k]) < 0x1p-45 ? 0 : slopes[k]; }
  void add(const Traced& x, long double by) {
    slopes.resize(std::max(slopes.size(), x.slopes.size()));
    for (std::size_t k = 0; k < x.slopes.size(); ++k) slopes[k] += by * x.slopes[k];
  }
  void add_rounding(double most, double here) {
    roundings.push_back({most, here});
    slopes.resize(roundings.size());
    slopes.back() = 1;
  }
  /// `value` has just been rounded from `exact`; what is not rounded here never is.
  Traced& rounded_from(const cln::cl_RA& exact) {
    const cln::cl_RA off = codegen::exact(value) - exact;
    const double most = 0x1p-53 * std::max(std::fabs(value), worst());
    if (!cln::zerop(off)) add_rounding(most, cln::double_approx(off));
    return *this;
  }
};
inline cln::cl_RA exact(const Traced& x) { return codegen::exact(x.value); }
inline Traced operator-(const Traced& x) {
  Traced r(-x.value);
  r.add(x, -1);
  return r;
}
inline Traced fused(const Traced& x, const Traced& y, const Traced& z) {
  Traced r(std::fma(x.value, y.value, z.value));
  r.add(x, y.value);
  r.add(y, x.value);
  r.add(z, 1);
  return r.rounded_from(exact(x) * exact(y) + exact(z));
}
inline Traced operator*(const Traced& x, const Traced& y) { return fused(x, y, 0); }
inline Traced operator+(const Traced& x, const Traced& y) { return fused(x, 1, y); }
inline Traced operator-(const Traced& x, const Traced& y) { return fused(y, -1, x); }
inline Traced operator/(const Traced& x, const Traced& y) {
  Traced r(x.value / y.value);
  r.add(x, 1 / (long double)(y.value));
  r.add(y, -(long double)(x.value) / y.value / y.value);
  return r.rounded_from(exact(x) / exact(y));
}
inline Traced square_root(const Traced& x) {
  Traced r(std::sqrt(x.value));
  r.add(x, 0.5L / std::sqrt((long double)(x.value)));
  const cln::cl_RA root = exact(r);
  return r.rounded_from(root + (exact(x) - root * root) / (2 * root));
}
inline magicmass::arithmetic::DoubleDouble<Traced> two_product(const Traced& x, const Traced& y) {
  const Traced product = x * y;
  return {product, fused(x, y, -product)};
}
inline bool is_above(const Traced& x, const Traced& y) { return x.value > y.value; }
inline Traced select(bool c, const Traced& x, const Traced& y) { return c ? x : y; }
}  // namespace test
