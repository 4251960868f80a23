// SPDX-License-Identifier: GPL-2.0-or-later
// Rationals and doubles.
#include "codegen/exact.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/real.h>

#include "codegen/quantity.hpp"

namespace codegen {
namespace {
cln::cl_RA times_power_of_2(const cln::cl_RA& x, long exponent) {
  const cln::cl_I power = cln::ash(1, std::labs(exponent));
  return exponent < 0 ? x / power : x * power;
}
}  // namespace

cln::cl_RA exact(double x) {
  if (!std::isfinite(x)) throw Refused("a number that is not finite");
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  const auto whole = std::int64_t(std::ldexp(mantissa, 53));
  return times_power_of_2(cln::cl_I(static_cast<long long>(whole)), exponent - 53);
}
double nearest(const cln::cl_RA& x) {
  if (cln::zerop(x)) return 0;
  const auto bits = [](const cln::cl_I& n) { return long(cln::integer_length(n)); };
  long exponent = bits(cln::abs(cln::numerator(x))) - bits(cln::denominator(x)) - 53;
  const cln::cl_RA whole = cln::abs(times_power_of_2(x, -exponent));
  if (whole >= cln::ash(1, 53)) ++exponent;
  if (exponent < -1012 || exponent > 950) throw Refused("a number that is no double");
  const double mantissa = cln::double_approx(cln::round1(times_power_of_2(x, -exponent)));
  return std::ldexp(mantissa, int(exponent));
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
