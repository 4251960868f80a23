// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers/ball.hpp"

#include <cmath>
#include <sstream>

#include <cln/integer_io.h>
#include <cln/io.h>

#include "answers/errors.hpp"

namespace answers {
namespace {

using cln::cl_I;
using cln::cl_RA;

/// The integer nearest to q, ties to even.
cl_I rounded(const cl_RA& q) { return cln::round1(q); }

/// q scaled by 2^e.
cl_RA scaled(const cl_RA& q, int e) {
  return e >= 0 ? q * cln::ash(cl_I(1), e) : q / cln::ash(cl_I(1), -e);
}
/// e with 2^e <= q < 2^(e+1), for q > 0.
int exponent_of(const cl_RA& q) {
  const auto length = [](const cl_I& n) { return static_cast<int>(cln::integer_length(n)); };
  const int e = length(cln::numerator(q)) - length(cln::denominator(q));
  return scaled(q, -e) < 1 ? e - 1 : e;
}
double nearest(const cl_RA& q) {
  if (q == 0) {
    return 0;
  }
  const cl_RA size = cln::abs(q);
  const int e = std::max(exponent_of(size), -1022) - 52;
  const cl_I whole = rounded(scaled(size, -e));  // at most 2^53
  const double value = std::ldexp(cln::double_approx(whole), e);
  return q < 0 ? -value : value;
}
std::string digits_of(const cl_I& n) {
  std::ostringstream out;
  out << n;
  return out.str();
}

}  // namespace

int Ball::bits_ = 128;

void Ball::set_bits(int bits) { bits_ = bits; }

Ball::Ball(const cl_RA& q) : middle(cln::floor1(scaled(q, bits_))), radius(1) {
  if (scaled(q, bits_) == middle) {
    radius = 0;
  }
}
Ball operator+(const Ball& a, const Ball& b) { return {a.middle + b.middle, a.radius + b.radius}; }
Ball operator-(const Ball& a, const Ball& b) { return {a.middle - b.middle, a.radius + b.radius}; }
Ball operator*(const Ball& a, const Ball& b) {
  const cl_I error =
      cln::abs(a.middle) * b.radius + cln::abs(b.middle) * a.radius + a.radius * b.radius;
  // One unit for the product's own rounding, one for that of its error.
  return {cln::ash(a.middle * b.middle, -Ball::bits_), cln::ash(error, -Ball::bits_) + 2};
}
Ball operator/(const Ball& a, const Ball& b) {
  const cl_I least = cln::abs(b.middle) - b.radius;
  if (least <= 0) {
    throw Undecided("a divisor is not certainly different from 0");
  }
  // |a/b - m_a/m_b| <= (r_a |m_b| + r_b |m_a|)/(|m_b| least)
  const cl_I quotient = cln::floor1(cln::ash(a.middle, Ball::bits_), b.middle);
  const cl_I error =
      cln::ash(a.radius * cln::abs(b.middle) + b.radius * cln::abs(a.middle), Ball::bits_);
  return {quotient, cln::floor1(error, cln::abs(b.middle) * least) + 2};
}
cl_RA Ball::low() const { return scaled(middle - radius, -bits_); }
cl_RA Ball::high() const { return scaled(middle + radius, -bits_); }

Ball Ball::pi() {
  // Machin: pi = 16 atan(1/5) - 4 atan(1/239); an alternating series is off by less than its next
  // term.
  const auto arc_tangent = [](int reciprocal) {
    const cl_I square = reciprocal * reciprocal;
    Ball power = Ball(cl_RA(1) / reciprocal);
    Ball sum = power;
    for (int k = 3;; k += 2) {
      power = power * Ball(cl_RA(1) / square);
      const Ball term = power * Ball(cl_RA(1) / k);
      if (cln::abs(term.middle) <= term.radius) {
        sum.radius = sum.radius + cln::abs(term.middle) + term.radius;
        return sum;
      }
      sum = k % 4 == 3 ? sum - term : sum + term;
    }
  };
  return Ball(16) * arc_tangent(5) - Ball(4) * arc_tangent(239);
}
Ball cos(const Ball& x) {
  const Ball square = x * x;
  Ball term = 1;
  Ball sum = 1;
  for (int k = 1;; ++k) {  // |x| <= 2: the terms fall from the second on
    term = term * square * Ball(cl_RA(1) / (2 * k * (2 * k - 1)));
    if (k > 1 && cln::abs(term.middle) <= term.radius) {
      sum.radius = sum.radius + cln::abs(term.middle) + term.radius;
      return sum;
    }
    sum = k % 2 == 1 ? sum - term : sum + term;
  }
}

std::optional<double> nearest_double(const cl_RA& low, const cl_RA& high) {
  const double value = nearest(low);
  if (value != nearest(high) || std::isinf(value)) {
    return {};
  }
  return value;
}
std::optional<std::string> decimal(const cl_RA& low, const cl_RA& high, int digits) {
  if (low == 0 && high == 0) {
    return "0";
  }
  if (low <= 0 && high >= 0) {
    return {};
  }
  const bool minus = high < 0;
  const cl_RA small = minus ? -high : low;
  const cl_RA large = minus ? -low : high;
  // The place of the first digit: 10^p <= small < 10^(p+1).
  int p = static_cast<int>(std::floor(exponent_of(small) * 0.30103));
  const auto power = [](int e) { return cln::expt(cl_RA(10), e); };
  while (power(p + 1) <= small) {
    ++p;
  }
  while (power(p) > small) {
    --p;
  }
  const cl_RA scale = power(digits - 1 - p);
  cl_I whole = rounded(small * scale);
  if (whole != rounded(large * scale)) {
    return {};
  }
  std::string text = digits_of(whole);
  if (static_cast<int>(text.size()) > digits) {  // 9.99... became 10.0
    text.pop_back();
    ++p;
  }
  std::string out = minus ? "-" : "";
  if (p >= 0 && p < digits - 1) {
    out += text.substr(0, std::size_t(p) + 1) + "." + text.substr(std::size_t(p) + 1);
  } else if (p < 0 && p >= -6) {
    out += "0." + std::string(std::size_t(-p - 1), '0') + text;
  } else {
    out += text.substr(0, 1) + (digits > 1 ? "." + text.substr(1) : "") + "e" + std::to_string(p);
  }
  return out;
}

}  // namespace answers
