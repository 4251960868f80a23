// SPDX-License-Identifier: GPL-2.0-or-later
// Rationals and doubles.
#include "codegen/exact.hpp"

#include <cmath>
#include <cstdio>

#include <cln/float.h>
#include <cln/real.h>

#include "codegen/quantity.hpp"

namespace codegen {
cln::cl_RA exact(double x) {
  if (!std::isfinite(x)) throw Refused("a number that is not finite");
  int exponent = 0;
  const double scaled = std::ldexp(std::frexp(x, &exponent), 53);
  const cln::cl_I mantissa(static_cast<long long>(scaled));
  return mantissa * cln::expt(cln::cl_RA(2), exponent - 53);
}
double nearest(const cln::cl_RA& x) {
  if (cln::zerop(x)) return 0;
  const cln::cl_RA size = cln::abs(x);
  const bool is_double = size >= exact(0x1p-960) && size <= exact(0x1p1000);
  if (!is_double) throw Refused("a number that is no double");
  return cln::double_approx(x);
}
double upper(const cln::cl_RA& x) {
  const double below = nearest(x);
  return exact(below) >= x ? below : std::nextafter(below, INFINITY);
}
bool is_double(const cln::cl_RA& x) { return exact(nearest(x)) == x; }
bool is_power_of_2(double x) {
  int exponent = 0;
  return std::fabs(std::frexp(x, &exponent)) == 0.5;
}
const cln::cl_RA& pi() {
  static const cln::cl_RA value = cln::rational(cln::pi(cln::float_format(140)));
  return value;
}

std::string hex(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", x);
  return text;
}
std::string as_power_of_2(double x) {
  if (x == 0) return "0";
  char text[40];
  std::snprintf(text, sizeof text, "2^%.1f", std::ceil(std::log2(x) * 10) / 10);
  return text;
}
}  // namespace codegen
