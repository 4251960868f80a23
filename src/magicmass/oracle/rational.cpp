// Doubles by their bits, rationals by comparison; no floating-point rounding takes part.
#include "magicmass/oracle/rational.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <cln/integer_io.h>
#include <cln/rational_io.h>

namespace magicmass::oracle {
namespace {

using Limits = std::numeric_limits<double>;
constexpr long smallest_spacing = Limits::min_exponent - Limits::digits;
constexpr long largest_spacing = Limits::max_exponent - Limits::digits;

/// x 2^exponent
cl_RA scaled(const cl_RA& x, long exponent) { return x * cln::expt(cl_RA(2), cl_I(exponent)); }

long bits_of(const cl_I& x) { return static_cast<long>(cln::integer_length(x)); }

/// log2 of the spacing of doubles in the binade of x > 0, were there no largest exponent: the
/// lengths of numerator and denominator leave two candidates for floor(log2 x).
long spacing_exponent(const cl_RA& x) {
  const long estimate = bits_of(cln::numerator(x)) - bits_of(cln::denominator(x));
  const long binade = x < scaled(1, estimate) ? estimate - 1 : estimate;
  return std::max(binade - (Limits::digits - 1), smallest_spacing);
}

}  // namespace

cl_RA exact(double value) {
  if (!std::isfinite(value))
    throw std::invalid_argument("an infinity or NaN is not a rational number");
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  const auto mantissa = static_cast<long long>(std::ldexp(fraction, Limits::digits));
  return scaled(cl_I(mantissa), exponent - Limits::digits);
}

double nearest(const cl_RA& x) {
  if (cln::zerop(x)) return 0;
  const cl_RA size = cln::abs(x);
  const long spacing = spacing_exponent(size);
  const cl_I whole = cln::round1(scaled(size, -spacing));  // ties to even
  // whole <= 2^53, so it is a double; ldexp only moves its exponent, or overflows:
  // mantissas are at least 2^52 there, and 2^52 2^972 is past the largest double.
  const double mantissa = cln::double_approx(whole);
  const int exponent = static_cast<int>(std::min(spacing, largest_spacing + 1));
  return std::ldexp(cln::minusp(x) ? -mantissa : mantissa, exponent);
}

double ulp_error(double got, const cl_RA& exact_value) {
  if (!std::isfinite(got)) return Limits::infinity();
  const long spacing = cln::zerop(exact_value)
                           ? smallest_spacing
                           : std::min(spacing_exponent(cln::abs(exact_value)), largest_spacing);
  return nearest(scaled(cln::abs(exact(got) - exact_value), -spacing));
}

long length(const cl_RA& x) { return bits_of(cln::numerator(x)) + bits_of(cln::denominator(x)); }

std::string to_text(const cl_RA& x) {
  std::ostringstream text;
  text << x;
  return text.str();
}

}  // namespace magicmass::oracle
