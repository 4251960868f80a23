// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/ratio_polynomials.hpp"

#include <string>

#include "algebraic/cosine_polynomial.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::algebraic {

// Let y = 2 cos(2 pi j/m) with minimal polynomial P, so 1 + ratio = 2/y. Then (1 + ratio)^d P(2/(1 + ratio)) vanishes:
// P's coefficients times powers of 2, in reverse order, shifted by 1. The ratio is of the same degree as y, since each
// is a rational function of the other; hence this is irreducible over the rational numbers.
Polynomial secant_polynomial(long m) {
  if (m < 1)
    throw InvalidInput("sec(2 pi/m) is asked for with m = " + std::to_string(m) +
                       "; m must be 1 or more");
  if (m == 4) throw InvalidInput("sec(pi/2) does not exist: m must not be 4");
  Polynomial scaled = cosine_polynomial(m);
  for (std::size_t i = 0; i < scaled.coefficients.size(); ++i)
    scaled.coefficients[i] = cln::ash(scaled.coefficients[i], static_cast<long>(i));
  return primitive(shifted_by_one(reversed(std::move(scaled))));
}

namespace {

void require_positive(long k) {
  if (k < 1) throw InvalidInput("k must be 1 or more, got " + std::to_string(k));
}

}  // namespace

Polynomial magic_polynomial(long k) {
  require_positive(k);
  return secant_polynomial(2 * (2 * k + 1));
}

Polynomial deficient_polynomial(long k) {
  require_positive(k);
  return secant_polynomial(4 * (k + 1));
}

}  // namespace magicmass::algebraic
