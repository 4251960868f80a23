// SPDX-License-Identifier: GPL-2.0-or-later
#include "equality/ball.hpp"

#include <algorithm>
#include <sstream>

#include <cln/integer.h>
#include <cln/integer_io.h>
#include <cln/real.h>

// CLN's elementary functions aim at an error below one unit in the last place. unit_ is 2^20 units of the last
// place, so each step may err a million times more, and every radius is enlarged by a relative 2^-20 as well,
// which covers the rounding of the radius itself.
namespace magicmass::equality {
namespace {

constexpr long slack_bits = 20;

bool is_zero(const cln::cl_F& x) { return cln::zerop(x); }

}  // namespace

BallArithmetic::BallArithmetic(int digits)
    : format_(cln::float_format(static_cast<uintE>(digits))),
      unit_(cln::scale_float(
          cln::cl_float(1, format_),
          slack_bits - static_cast<long>(cln::float_digits(cln::cl_float(1, format_))))) {}

Ball BallArithmetic::rounded(const cln::cl_F& middle, const cln::cl_F& radius) const {
  const cln::cl_F error = radius + cln::abs(middle) * unit_;
  return {middle, error + cln::scale_float(error, -slack_bits)};
}

Ball BallArithmetic::number(const cln::cl_RA& value) const {
  const cln::cl_F zero = cln::cl_float(0, format_);
  if (value == 0) return {zero, zero};
  return rounded(cln::cl_float(value, format_), zero);
}

Ball BallArithmetic::pi() const { return rounded(cln::pi(format_), cln::cl_float(0, format_)); }

Ball BallArithmetic::sum(const Ball& x, const Ball& y) const {
  return rounded(x.middle + y.middle, x.radius + y.radius);
}

Ball BallArithmetic::product(const Ball& x, const Ball& y) const {
  return rounded(x.middle * y.middle, cln::abs(x.middle) * y.radius +
                                          cln::abs(y.middle) * x.radius + x.radius * y.radius);
}

std::optional<Ball> BallArithmetic::reciprocal(const Ball& x) const {
  const cln::cl_F size = cln::abs(x.middle);
  // Half the distance keeps the quotient below from being spoilt by rounding of the difference.
  if (size <= x.radius + x.radius) return std::nullopt;
  return rounded(cln::cl_float(1, format_) / x.middle, x.radius / (size * (size - x.radius)));
}

std::optional<Ball> BallArithmetic::root(const Ball& x, long order) const {
  if (x.middle <= x.radius + x.radius) return std::nullopt;
  const auto value = [&](const cln::cl_F& argument) {
    if (order == 2) return cln::sqrt(argument);
    return cln::cl_float(cln::realpart(cln::exp(cln::ln(argument) / order)), format_);
  };
  const cln::cl_F middle = value(x.middle);
  // Concave: the derivative at the lower end bounds the slope.
  const cln::cl_F low = x.middle - x.radius;
  const cln::cl_F slope = value(low) / (low * order);
  // exp(ln x/k): an error of unit |ln x|/k in the exponent, relative to the result.
  const cln::cl_F exponent_error = order == 2
                                       ? cln::cl_float(0, format_)
                                       : cln::abs(middle) * unit_ * cln::abs(cln::ln(x.middle));
  return rounded(middle, slope * x.radius + exponent_error);
}

Ball BallArithmetic::absolute(const Ball& x) const { return {cln::abs(x.middle), x.radius}; }

// The argument is reduced modulo pi/2, so that its own rounding counts: unit_ times |x| + 1.
std::optional<Ball> BallArithmetic::sine(const Ball& x) const {
  if (cln::abs(x.middle) > cln::cl_float(1e30, format_)) return std::nullopt;
  return rounded(cln::sin(x.middle), x.radius + unit_ * (cln::abs(x.middle) + 1));
}

std::optional<Ball> BallArithmetic::cosine(const Ball& x) const {
  if (cln::abs(x.middle) > cln::cl_float(1e30, format_)) return std::nullopt;
  return rounded(cln::cos(x.middle), x.radius + unit_ * (cln::abs(x.middle) + 1));
}

// 1/(1 + x^2) at the end next to 0 bounds the slope: of a huge x the arctangent is known better than x.
Ball BallArithmetic::arctangent(const Ball& x) const {
  const cln::cl_F nearest = cln::abs(x.middle) - x.radius;
  const cln::cl_F one = cln::cl_float(1, format_);
  const bool is_beyond_one = cln::abs(x.middle) > x.radius + x.radius && nearest > one;
  return rounded(cln::cl_float(cln::atan(x.middle), format_),
                 is_beyond_one ? x.radius / (nearest * nearest) : x.radius);
}

std::optional<Ball> BallArithmetic::exponential(const Ball& x) const {
  if (cln::abs(x.middle) > cln::cl_float(100000, format_) || x.radius > cln::cl_float(1, format_))
    return std::nullopt;
  const cln::cl_F middle = cln::exp(x.middle);
  // exp(x + r) - exp(x) <= 2 r exp(x) for r <= 1
  return rounded(middle, middle * (2 * x.radius + unit_ * (cln::abs(x.middle) + 1)));
}

std::optional<Ball> BallArithmetic::logarithm(const Ball& x) const {
  if (x.middle <= x.radius + x.radius) return std::nullopt;
  return rounded(cln::ln(x.middle), x.radius / (x.middle - x.radius) + unit_);
}

std::optional<int> sign(const Ball& ball) {
  if (is_zero(ball.middle) && is_zero(ball.radius)) return 0;
  if (cln::abs(ball.middle) <= ball.radius + ball.radius) return std::nullopt;
  return cln::minusp(ball.middle) ? -1 : 1;
}

std::string shown(const Ball& ball, int most_digits) {
  if (is_zero(ball.middle)) return "0";
  const cln::cl_RA exact = cln::abs(cln::rational(ball.middle));
  // exponent with 10^exponent <= exact < 10^(exponent + 1), from an estimate put right
  const cln::float_format_t coarse = cln::float_format(20);
  const cln::cl_F logarithm =
      cln::ln(cln::cl_float(exact, coarse)) / cln::ln(cln::cl_float(10, coarse));
  long exponent = cln::cl_I_to_long(cln::floor1(logarithm));
  if (exponent > 5000 || exponent < -5000)  // written out it would tell nobody more
    return std::string(cln::minusp(ball.middle) ? "-" : "") + "about 10^" +
           std::to_string(exponent);
  while (cln::expt(cln::cl_RA(10), cln::cl_I(exponent)) > exact) --exponent;
  while (cln::expt(cln::cl_RA(10), cln::cl_I(exponent + 1)) <= exact) ++exponent;
  int digits = most_digits;
  if (!is_zero(ball.radius)) {  // no more than are certain, but for the last one
    const cln::cl_F known = cln::ln(cln::cl_float(exact / cln::rational(ball.radius), coarse)) /
                            cln::ln(cln::cl_float(10, coarse));
    digits = std::clamp(cln::cl_I_to_int(cln::floor1(known)), 1, most_digits);
  }
  const cln::cl_I scaled =
      cln::round1(exact * cln::expt(cln::cl_RA(10), cln::cl_I(digits - 1 - exponent)));
  std::ostringstream out;
  out << scaled;
  std::string all = out.str();
  if (static_cast<int>(all.size()) > digits) {  // rounded up to a power of ten
    ++exponent;
    all.pop_back();
  }
  const std::string minus = cln::minusp(ball.middle) ? "-" : "";
  if (exponent < -5 || exponent >= digits) {
    const std::string fraction = all.substr(1);
    return minus + all.substr(0, 1) + (fraction.empty() ? "" : "." + fraction) + "e" +
           std::to_string(exponent);
  }
  if (exponent < 0) all.insert(0, static_cast<std::size_t>(-exponent), '0');
  const std::size_t whole = exponent < 0 ? 1 : static_cast<std::size_t>(exponent) + 1;
  const std::string fraction = all.substr(whole);
  return minus + all.substr(0, whole) + (fraction.empty() ? "" : "." + fraction);
}

}  // namespace magicmass::equality
