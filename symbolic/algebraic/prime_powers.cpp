// SPDX-License-Identifier: GPL-2.0-or-later
#include "algebraic/prime_powers.hpp"

#include <cln/integer.h>

namespace magicmass::algebraic {

using cln::cl_I;

std::vector<std::pair<cl_I, long>> prime_powers(const cln::cl_RA& r) {
  std::vector<std::pair<cl_I, long>> result;
  const auto factor = [&result](cl_I rest, long sign) {
    for (long p = 2; p < 1000 && rest > 1; p += p == 2 ? 1 : 2) {
      long exponent = 0;
      for (; cln::zerop(cln::mod(rest, cl_I(p))); rest = cln::exquo(rest, cl_I(p))) ++exponent;
      if (exponent > 0) result.emplace_back(p, sign * exponent);
    }
    if (rest > 1) result.emplace_back(rest, sign);
  };
  factor(cln::numerator(r), 1);
  factor(cln::denominator(r), -1);
  return result;
}

}  // namespace magicmass::algebraic
