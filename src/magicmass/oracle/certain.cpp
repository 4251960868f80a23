// The two families are typed here by their definition, sec x - 1 (Ee & Lee, Table II), so that the
// oracle shares nothing with what is derived and generated.
#include "magicmass/oracle/certain.hpp"

#include <cln/float.h>
#include <cln/real.h>

namespace magicmass::oracle {
namespace {

/// sec(pi/divisor) - 1 for divisor >= 4. CLN works with 64 bits more than asked; its manual
/// promises pi and cos to about the last place, and 2^32 times that is allowed here. The cosine is
/// at least 1/2, so the secant is off by at most 4 times that.
Interval secant_less_one(const cl_I& divisor, long precision) {
  const auto digits = static_cast<unsigned long>(static_cast<double>(precision + 64) * 0.30103) + 2;
  const cln::cl_F angle = cln::pi(cln::float_format(digits)) / divisor;
  const cl_RA cosine = cln::rational(cln::cos(angle));
  const cl_RA slack = cln::recip(cl_RA(cln::ash(cl_I(1), precision + 32)));
  return {cln::recip(cosine + slack) - 1, cln::recip(cosine - slack) - 1, precision};
}

MassRatio secant_ratio(const cl_I& divisor) {
  const auto bits = static_cast<long>(cln::integer_length(divisor));
  const auto enclosed = [divisor](long precision) { return secant_less_one(divisor, precision); };
  return {std::nullopt, enclosed, 2 * bits};
}

}  // namespace

MassRatio ratio(const cl_RA& alpha) {
  if (!cln::plusp(alpha))
    throw std::invalid_argument("alpha must be positive, got " + to_text(alpha));
  const auto enclosed = [alpha](long precision) { return Interval(alpha, precision); };
  return {alpha, enclosed, length(alpha)};
}

MassRatio operator*(const MassRatio& alpha, const cl_RA& factor) {
  if (alpha.rational) return ratio(*alpha.rational * factor);
  const auto enclosed = [alpha, factor](long precision) {
    return alpha.enclosed(precision) * Interval(factor, precision);
  };
  return {std::nullopt, enclosed, alpha.length + length(factor)};
}

// sec(pi/3) - 1 = 1; as a number it lets exact zeros be seen.
MassRatio magic(const cl_I& k) { return k == 1 ? ratio(1) : secant_ratio(2 * k + 1); }

MassRatio deficient(const cl_I& k) { return secant_ratio(2 * (k + 1)); }

// Where both ends round alike, so does all that lies between them.
Rounding<double> to_double() {
  const auto common = [](const cl_RA& low, const cl_RA& high) {
    const double value = nearest(low);
    return value == nearest(high) ? std::optional(value) : std::nullopt;
  };
  return {common, 64};
}

Rounding<cl_RA> to_within(long bits) {
  const auto common = [bits](const cl_RA& low, const cl_RA& high) {
    const cl_RA smallest = cln::min(cln::abs(low), cln::abs(high));
    const bool close = (high - low) * cln::ash(cl_I(1), bits) < smallest;
    return low == high || close ? std::optional(low) : std::nullopt;
  };
  return {common, bits};
}

cl_I exact_length(const cl_RA& alpha, const cl_I& j) {
  // Both collisions have entries of the same size, so either one's common denominator will do.
  const Map<cl_RA> map = cycle_of(alpha).with_A;
  cl_I common(1);
  for (const cl_RA& entry : map.reshaped()) common = cln::lcm(common, cln::denominator(entry));
  return j * cl_I(static_cast<unsigned long>(cln::integer_length(common - 1)));
}

}  // namespace magicmass::oracle
