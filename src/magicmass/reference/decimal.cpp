// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/decimal.hpp"

#include <cstddef>

#include <cln/integer.h>

#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// x 10^exponent
cl_RA times_power_of_ten(const cl_RA& x, long exponent) {
  return x * cln::expt(cl_RA(10), cl_I(exponent));
}

/// floor(log10 x) for x > 0. The binary lengths give it within one; exact comparison settles it.
long decade(const cl_RA& x) {
  const long bits = static_cast<long>(cln::integer_length(cln::numerator(x))) -
                    static_cast<long>(cln::integer_length(cln::denominator(x)));
  auto estimate = static_cast<long>(static_cast<double>(bits) * 0.30102999566398120);
  while (times_power_of_ten(x, -estimate) < 1) {
    --estimate;
  }
  while (times_power_of_ten(x, -estimate) >= 10) {
    ++estimate;
  }
  return estimate;
}

cl_I rounded_to_even(const cl_RA& x) {
  const cl_I whole = cln::floor1(x);
  const cl_RA twice_rest = (x - whole) * 2;
  return twice_rest > 1 || (twice_rest == 1 && cln::oddp(whole)) ? whole + 1 : whole;
}

/// sign and digits d1 d2 d3... meaning d1.d2d3... 10^exponent
std::string placed(std::string text, const std::string& digits, long exponent) {
  const auto length = static_cast<long>(digits.size());
  const bool plain = exponent >= -5 && exponent < length;
  if (plain && exponent < 0) {
    return text.append("0.").append(static_cast<std::size_t>(-exponent - 1), '0').append(digits);
  }
  const std::size_t before_point = plain ? static_cast<std::size_t>(exponent) + 1 : 1;
  text.append(digits, 0, before_point);
  if (before_point < digits.size()) {
    text.append(".").append(digits, before_point);
  }
  return plain ? text : text.append("e").append(std::to_string(exponent));
}

}  // namespace

std::string to_decimal(const cl_RA& x, int digits) {
  if (digits < 1) {
    throw InvalidInput("the number of digits must be 1 or more, got " + std::to_string(digits));
  }
  if (cln::zerop(x)) {
    return "0";
  }
  const cl_RA size = cln::abs(x);
  long exponent = decade(size);
  std::string text = to_text(rounded_to_even(times_power_of_ten(size, digits - 1 - exponent)));
  if (text.size() > static_cast<std::size_t>(digits)) {  // 9.99... became 10.0...
    text.pop_back();
    ++exponent;
  }
  return placed(cln::minusp(x) ? "-" : "", text, exponent);
}

}  // namespace magicmass::reference
