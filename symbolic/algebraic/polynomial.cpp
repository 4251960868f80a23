// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/polynomial.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <cln/integer_io.h>

namespace magicmass::algebraic {

using cln::cl_I;

std::string to_text(const Polynomial& polynomial, const std::string& variable) {
  std::ostringstream out;
  for (long power = polynomial.degree(); power >= 0; --power) {
    const cl_I& coefficient = polynomial.coefficients[static_cast<std::size_t>(power)];
    if (cln::zerop(coefficient)) continue;
    const bool leads = power == polynomial.degree();
    out << (cln::minusp(coefficient) ? (leads ? "-" : " - ") : (leads ? "" : " + "));
    const cl_I size = cln::abs(coefficient);
    if (size != 1 || power == 0) out << size << (power > 0 ? "*" : "");
    if (power > 0) out << variable;
    if (power > 1) out << '^' << power;
  }
  return out.str();
}

Polynomial primitive(Polynomial polynomial) {
  cl_I content = 0;
  for (const cl_I& coefficient : polynomial.coefficients) content = cln::gcd(content, coefficient);
  if (cln::minusp(polynomial.coefficients.back())) content = -content;
  for (cl_I& coefficient : polynomial.coefficients) coefficient = cln::exquo(coefficient, content);
  return polynomial;
}

Polynomial exact_quotient(Polynomial dividend, const Polynomial& divisor) {
  std::vector<cl_I>& rest = dividend.coefficients;
  const std::size_t divisor_degree = divisor.coefficients.size() - 1;
  Polynomial quotient;
  quotient.coefficients.resize(rest.size() - divisor_degree);
  for (std::size_t i = quotient.coefficients.size(); i-- > 0;) {
    const cl_I factor = rest[i + divisor_degree];
    quotient.coefficients[i] = factor;
    if (cln::zerop(factor)) continue;
    for (std::size_t j = 0; j <= divisor_degree; ++j)
      rest[i + j] = rest[i + j] - factor * divisor.coefficients[j];
  }
  if (!std::all_of(rest.begin(), rest.end(), [](const cl_I& c) { return cln::zerop(c); }))
    throw std::logic_error("a division of polynomials that should be exact leaves a remainder");
  return quotient;
}

Polynomial shifted_by_one(Polynomial polynomial) {
  std::vector<cl_I>& c = polynomial.coefficients;
  for (std::size_t i = 1; i < c.size(); ++i)
    for (std::size_t j = c.size() - 1; j-- > i - 1;) c[j] = c[j] + c[j + 1];
  return polynomial;
}

Polynomial reversed(Polynomial polynomial) {
  std::reverse(polynomial.coefficients.begin(), polynomial.coefficients.end());
  while (cln::zerop(polynomial.coefficients.back())) polynomial.coefficients.pop_back();
  return polynomial;
}

Polynomial derivative(const Polynomial& polynomial) {
  Polynomial result;
  for (std::size_t i = 1; i < polynomial.coefficients.size(); ++i)
    result.coefficients.push_back(polynomial.coefficients[i] * cl_I(i));
  return result;
}

}  // namespace magicmass::algebraic
