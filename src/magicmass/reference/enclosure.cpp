// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/enclosure.hpp"

#include <cstdint>

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/real.h>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// sec(pi/denominator) - 1 for denominator >= 3. CLN works with 64 bits more than asked; its manual promises pi and
/// cos to about the last place, and 2^32 times that is allowed here. The cosine is in [1/2, 1), so the secant is
/// off by at most 4 times that.
Interval secant_less_one(const cl_I& denominator, long precision) {
  const auto digits = static_cast<unsigned long>(static_cast<double>(precision + 64) * 0.30103) + 2;
  const cln::cl_F angle = cln::pi(cln::float_format(digits)) / denominator;
  const cl_RA cosine = cln::rational(cln::cos(angle));
  const cl_RA slack = cln::recip(cl_RA(cln::ash(cl_I(1), precision + 32)));
  return {cln::recip(cosine + slack) - 1, cln::recip(cosine - slack) - 1, precision};
}

}  // namespace

Enclosure enclosure(const cl_RA& x) {
  return [x](long precision) { return Interval(x, precision); };
}

Enclosure enclosure(const MassRatio& alpha) {
  if (const std::optional<cl_RA> value = exact(alpha)) {
    return enclosure(*value);
  }
  const auto* magic = std::get_if<Magic>(&alpha);
  const std::int64_t k = magic != nullptr ? magic->k : std::get<Deficient>(alpha).k;
  if (k < 1) {
    throw InvalidInput("k must be 1 or more, got " + std::to_string(k));
  }
  if (magic != nullptr && k == 1) {
    return enclosure(cl_RA(1));  // sec(pi/3) - 1; as a point it lets exact zeros be seen
  }
  const cl_I index(static_cast<long>(k));
  const cl_I denominator = magic != nullptr ? 2 * index + 1 : 2 * (index + 1);
  return [denominator](long precision) { return secant_less_one(denominator, precision); };
}

}  // namespace magicmass::reference
