// Rationals and doubles; outward rounding by stepping to neighbours.
#include "codegen/exact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <cln/float.h>
#include <cln/real.h>

namespace codegen {
namespace {
constexpr double pi_below = 0x1.921fb54442d18p+1;
constexpr int libm_steps = 4;
std::string formatted(const char* format, double x) {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}
}  // namespace

cln::cl_RA exact(double x) {
  if (!std::isfinite(x)) throw Refused("a number that is not finite");
  int exponent = 0;
  const cln::cl_I mantissa(static_cast<long long>(std::ldexp(std::frexp(x, &exponent), 53)));
  return mantissa * cln::expt(cln::cl_RA(2), exponent - 53);
}
double nearest(const cln::cl_RA& x) {
  if (cln::zerop(x)) return 0;
  const cln::cl_RA size = cln::abs(x);
  if (size < exact(0x1p-960) || size > exact(0x1p1000)) throw Refused("a number that is no double");
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

std::string hex(double x) { return formatted("%a", x); }
std::string as_power_of_2(double x) {
  return x == 0 ? "0" : formatted("2^%.1f", std::ceil(std::log2(x) * 10) / 10);
}

double Interval::size() const { return std::max(std::fabs(low), std::fabs(high)); }
double Interval::least() const { return std::max({0.0, low, -high}); }

Interval meet(Interval x, Interval y) {
  const Interval r{std::max(x.low, y.low), std::min(x.high, y.high)};
  if (!(r.low <= r.high)) throw Refused("two intervals of one number have nothing in common");
  return r;
}
Interval around(double low, double high, int steps) {
  for (int k = 0; k < steps; ++k) {
    low = std::nextafter(low, -infinity);
    high = std::nextafter(high, infinity);
  }
  return {low, high};
}
Interval operator+(Interval x, Interval y) {
  const Interval sum{x.low + y.low, x.high + y.high}, r = around(sum.low, sum.high);
  return {sum.low == 0 ? 0 : r.low, sum.high == 0 ? 0 : r.high};  // a sum that rounds to 0 is 0
}
Interval operator*(Interval x, Interval y) {
  const auto of = [](double a, double b) { return a == 0.0 || b == 0.0 ? 0.0 : a * b; };
  const double p[] = {of(x.low, y.low), of(x.low, y.high), of(x.high, y.low), of(x.high, y.high)};
  const Interval r = around(*std::min_element(p, p + 4), *std::max_element(p, p + 4));
  const bool alike = (x.low >= 0 && y.low >= 0) || (x.high <= 0 && y.high <= 0);
  const bool unlike = (x.low >= 0 && y.high <= 0) || (x.high <= 0 && y.low >= 0);
  return {alike ? std::max(0.0, r.low) : r.low, unlike ? std::min(0.0, r.high) : r.high};
}
Interval operator/(Interval x, Interval y) {
  if (y.low < 0 && y.high <= 0) return Interval{-x.high, -x.low} / Interval{-y.high, -y.low};
  if (y.low < 0 || y.high == 0)
    throw Refused("a divisor that may be 0: its range needs a theorem or a guard");
  return x * meet(around(1 / y.high, y.low > 0 ? 1 / y.low : infinity), {0, infinity});
}
Interval root(Interval x) {
  if (!(x.low >= 0)) throw Refused("a square root of what may be negative");
  return meet(around(std::sqrt(x.low), std::sqrt(x.high)), {0, infinity});
}
Interval reciprocal_root(Interval x) {
  if (!(x.low >= 0)) throw Refused("a reciprocal root of what may be negative");
  const Interval r = around(1 / std::sqrt(x.high), x.low > 0 ? 1 / std::sqrt(x.low) : infinity, 2);
  return meet(r, {0, infinity});
}
Interval magnitude(Interval x) { return {x.least(), x.size()}; }
Interval arc_tangent(Interval x) {
  const Interval r = around(std::atan(x.low), std::atan(x.high), libm_steps);
  return x.low >= 0 ? meet(r, {0, infinity}) : r;
}
Interval sine(Interval x) {
  if (!(x.low >= -pi_below / 2 && x.high <= pi_below)) return {-1, 1};
  const auto [least, most] = std::minmax({std::sin(x.low), std::sin(x.high)});
  const bool has_top = x.low <= pi_below / 2 && x.high >= pi_below / 2;
  return meet(around(least, has_top ? 1.0 : most, libm_steps), {x.low >= 0 ? 0.0 : -1.0, 1});
}
Interval cosine(Interval x) {
  if (!(x.low >= -pi_below && x.high <= pi_below)) return {-1, 1};
  const Interval size = magnitude(x);
  return meet(around(std::cos(size.high), std::cos(size.low), libm_steps), {-1, 1});
}
}  // namespace codegen
