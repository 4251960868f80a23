// SPDX-License-Identifier: GPL-2.0-or-later
// Polynomials in one variable over the integers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <cln/integer.h>

namespace magicmass::algebraic {

/// A polynomial in one variable, not 0.
struct Polynomial {
  std::vector<cln::cl_I> coefficients;  ///< of 1, x, x^2, ...; the last is not 0

  /// The highest power.
  long degree() const { return static_cast<long>(coefficients.size()) - 1; }
  /// The same coefficients.
  bool operator==(const Polynomial& other) const = default;
};

/// x^3 + 4*x^2 - 3*x - 1
std::string to_text(const Polynomial& polynomial, const std::string& variable = "x");

/// Divided by the gcd of its coefficients, the leading one positive; the polynomial is not 0.
Polynomial primitive(Polynomial polynomial);

/// The quotient by a divisor with leading coefficient 1 that leaves no remainder.
Polynomial exact_quotient(Polynomial dividend, const Polynomial& divisor);

/// p(x + 1)
Polynomial shifted_by_one(Polynomial polynomial);

/// x^degree p(1/x)
Polynomial reversed(Polynomial polynomial);

/// Its first derivative.
Polynomial derivative(const Polynomial& polynomial);

}  // namespace magicmass::algebraic
