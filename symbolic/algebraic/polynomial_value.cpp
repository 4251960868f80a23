// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/polynomial_value.hpp"

#include <cstddef>

namespace magicmass::algebraic {

Interval value(const Polynomial& polynomial, const Interval& x, long precision) {
  Interval result(0, precision);
  for (std::size_t i = polynomial.coefficients.size(); i-- > 0;)
    result = sum(product(result, x, precision), {polynomial.coefficients[i], precision}, precision);
  return result;
}

}  // namespace magicmass::algebraic
