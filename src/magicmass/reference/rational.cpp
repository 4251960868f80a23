// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/rational.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

#include <cln/integer.h>
#include <cln/integer_io.h>
#include <cln/rational_io.h>

#include "magicmass/errors.hpp"

namespace magicmass::reference {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// 2^exponent
cl_RA power_of_two(long exponent) {
  const cl_I power = cln::ash(cl_I(1), exponent < 0 ? -exponent : exponent);
  return exponent < 0 ? cln::recip(cl_RA(power)) : cl_RA(power);
}

template <std::floating_point Float>
cl_RA exact_value_of(Float value) {
  constexpr int digits = std::numeric_limits<Float>::digits;
  static_assert(digits <= 64 && std::numeric_limits<Float>::radix == 2);
  if (!std::isfinite(value)) {
    throw InvalidInput("an infinity or NaN is no rational number");
  }
  int exponent = 0;
  const Float fraction = std::frexp(std::fabs(value), &exponent);  // value = fraction * 2^exponent
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, digits));
  const cl_RA size = cl_I(static_cast<unsigned long>(mantissa)) * power_of_two(exponent - digits);
  return std::signbit(value) ? -size : size;
}

/// floor(log2 |x|) for x != 0: the lengths of numerator and denominator leave two candidates.
long binade(const cl_RA& x) {
  const cl_RA size = cln::abs(x);
  const long estimate = static_cast<long>(cln::integer_length(cln::numerator(size))) -
                        static_cast<long>(cln::integer_length(cln::denominator(size)));
  return size < power_of_two(estimate) ? estimate - 1 : estimate;
}

/// log2 of the spacing of Float in the binade of x != 0, were there no largest exponent.
template <std::floating_point Float>
long spacing_exponent(const cl_RA& x) {
  using Limits = std::numeric_limits<Float>;
  const long smallest = Limits::min_exponent - Limits::digits;
  return std::max(binade(x) - (Limits::digits - 1), smallest);
}

cl_I parse_digits(std::string_view digits, std::string_view text) {
  const bool valid = !digits.empty() && std::all_of(digits.begin(), digits.end(),
                                                    [](char c) { return c >= '0' && c <= '9'; });
  if (!valid) {
    throw InvalidInput("not a rational number: \"" + std::string(text.substr(0, 60)) +
                       "\"; allowed: whole numbers and fractions like -3 or 1/7");
  }
  return {std::string(digits).c_str()};
}

template <class Number>
std::string printed(const Number& number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

}  // namespace

cl_RA exact(float value) { return exact_value_of(value); }
cl_RA exact(double value) { return exact_value_of(value); }
cl_RA exact(long double value) { return exact_value_of(value); }

std::optional<cl_RA> exact(const MassRatio& alpha) {
  if (const auto* value = std::get_if<double>(&alpha)) {
    return exact(*value);
  }
  if (const auto* fraction = std::get_if<Fraction>(&alpha)) {
    return parse_rational(fraction->numerator + "/" + fraction->denominator);
  }
  return std::nullopt;
}

template <std::floating_point Float>
Float nearest(const cl_RA& x) {
  using Limits = std::numeric_limits<Float>;
  if (cln::zerop(x)) {
    return Float{0};
  }
  const long spacing = spacing_exponent<Float>(x);
  const cl_RA units = cln::abs(x) * power_of_two(-spacing);
  cl_I whole = cln::floor1(units);
  const cl_RA rest = units - whole;
  const cl_RA half = cl_RA(1) / 2;
  if (rest > half || (rest == half && cln::oddp(whole))) {
    whole = whole + 1;
  }
  // whole <= 2^digits with equality after a carry: a Float times a power of two
  const long length = static_cast<long>(cln::integer_length(whole));
  if (length + spacing > Limits::max_exponent) {
    return cln::minusp(x) ? -Limits::infinity() : Limits::infinity();
  }
  const Float mantissa = length > Limits::digits ? std::ldexp(Float{1}, Limits::digits)
                                                 : static_cast<Float>(cln::cl_I_to_ulong(whole));
  const Float size = std::ldexp(mantissa, static_cast<int>(spacing));
  return cln::minusp(x) ? -size : size;
}

template float nearest<float>(const cl_RA&);
template double nearest<double>(const cl_RA&);
template long double nearest<long double>(const cl_RA&);

template <std::floating_point Float>
double ulp_error(Float got, const cl_RA& exact_value) {
  using Limits = std::numeric_limits<Float>;
  if (!std::isfinite(got)) {
    return std::numeric_limits<double>::infinity();
  }
  const long smallest = Limits::min_exponent - Limits::digits;
  const long largest = Limits::max_exponent - Limits::digits;
  const long spacing =
      cln::zerop(exact_value) ? smallest : std::min(spacing_exponent<Float>(exact_value), largest);
  return nearest<double>(cln::abs(exact(got) - exact_value) * power_of_two(-spacing));
}

template double ulp_error<float>(float, const cl_RA&);
template double ulp_error<double>(double, const cl_RA&);
template double ulp_error<long double>(long double, const cl_RA&);

std::string to_text(const cl_RA& x) { return printed(x); }
std::string to_text(const cl_I& n) { return printed(n); }

cl_RA parse_rational(std::string_view text) {
  const bool negative = text.starts_with('-');
  const std::string_view size = text.substr(negative ? 1 : 0);
  const std::size_t slash = size.find('/');
  const cl_I numerator = parse_digits(size.substr(0, slash), text);
  const cl_I denominator =
      slash == std::string_view::npos ? cl_I(1) : parse_digits(size.substr(slash + 1), text);
  if (cln::zerop(denominator)) {
    throw InvalidInput("division by zero: " + std::string(text.substr(0, 60)));
  }
  const cl_RA value = cl_RA(numerator) / denominator;
  return negative ? -value : value;
}

}  // namespace magicmass::reference
