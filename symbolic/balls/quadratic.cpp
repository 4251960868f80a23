// SPDX-License-Identifier: GPL-2.0-or-later
#include "balls/quadratic.hpp"

#include <cmath>
#include <limits>

#include <cln/real.h>

#include "kernel/expr.hpp"

namespace balls {
namespace {

using cln::cl_I;
using cln::cl_RA;

std::size_t length(const cl_RA& q) {
  return cln::integer_length(cln::numerator(q)) + cln::integer_length(cln::denominator(q));
}

}  // namespace

Quadratic::Quadratic(const cl_RA& a, const cl_RA& b, const cl_I& d)
    : a_(a), b_(b), d_(cln::zerop(b) ? cl_I(1) : d) {}

Quadratic::Quadratic(double value) : Quadratic(exact(value)) {}

Quadratic Quadratic::sqrt(const Quadratic& x) {
  if (!cln::zerop(x.b_)) throw std::domain_error("a square root in a square root");
  if (cln::minusp(x.a_)) throw std::domain_error("the square root of a negative number");
  cl_I rest = cln::numerator(x.a_) * cln::denominator(x.a_);
  cl_RA outside = cln::recip(cln::denominator(x.a_));
  cl_I root;
  if (cln::sqrtp(rest, &root)) return root * outside;
  for (int p = 2; p < 1000; ++p) {
    while (cln::zerop(cln::mod(rest, p * p))) {
      rest = cln::exquo(rest, p * p);
      outside = outside * p;
    }
  }
  return {0, outside, rest};
}

const cl_I& Quadratic::common(const Quadratic& x, const Quadratic& y) {
  if (cln::zerop(x.b_)) return y.d_;
  if (!cln::zerop(y.b_) && x.d_ != y.d_) throw std::domain_error("two different square roots");
  return x.d_;
}

Quadratic operator+(const Quadratic& x, const Quadratic& y) {
  return {x.a_ + y.a_, x.b_ + y.b_, Quadratic::common(x, y)};
}
Quadratic operator-(const Quadratic& x, const Quadratic& y) {
  return {x.a_ - y.a_, x.b_ - y.b_, Quadratic::common(x, y)};
}
Quadratic operator*(const Quadratic& x, const Quadratic& y) {
  const cl_I& d = Quadratic::common(x, y);
  return {x.a_ * y.a_ + x.b_ * y.b_ * d, x.a_ * y.b_ + x.b_ * y.a_, d};
}
Quadratic operator/(const Quadratic& x, const Quadratic& y) {
  const cl_RA norm = y.a_ * y.a_ - y.b_ * y.b_ * y.d_;
  if (cln::zerop(norm)) throw std::domain_error("a division by 0");
  return x * Quadratic(y.a_ / norm, -y.b_ / norm, y.d_);
}

int Quadratic::sign() const {
  const auto sign_of = [](const cl_RA& q) { return cln::minusp(q) ? -1 : cln::plusp(q) ? 1 : 0; };
  const int a = sign_of(a_);
  const int b = sign_of(b_);
  if (a * b >= 0) return a == 0 ? b : a;
  return a_ * a_ < b_ * b_ * d_ ? b : a;
}

int Quadratic::compared(const Quadratic& x, const Quadratic& y) {
  const bool are_rational = cln::zerop(x.b_) && cln::zerop(y.b_);
  return are_rational ? cln::compare(x.a_, y.a_) : (x - y).sign();  // the former needs no gcd
}

std::size_t Quadratic::bits() const { return length(a_) + (cln::zerop(b_) ? 0 : length(b_)); }

std::optional<double> Quadratic::to_double() const {
  if (sign() == 0) return 0.0;
  cl_I root;
  cln::isqrt(cln::ash(d_, 256), &root);
  const cl_RA part = b_ * root / cln::ash(cl_I(1), 128);
  // Of two parts that cancel, the norm over their difference.
  const cl_RA near =
      cln::minusp(a_ * b_) ? (a_ * a_ - b_ * b_ * d_) / (a_ - part) : cl_RA(a_ + part);
  const cl_RA size = cln::abs(near);
  if (size > Quadratic(std::numeric_limits<double>::max()).a_) return std::nullopt;
  if (size < Quadratic(std::numeric_limits<double>::min()).a_) return std::nullopt;
  return cln::double_approx(near);
}

std::string Quadratic::text() const {
  if (cln::zerop(b_)) return kernel::digits(a_);
  const std::string root = "sqrt(" + kernel::digits(d_) + ")";
  const cl_RA size = cln::abs(b_);
  const std::string sign = cln::minusp(b_) ? "-" : cln::zerop(a_) ? "" : "+";
  return (cln::zerop(a_) ? "" : kernel::digits(a_)) + sign +
         (size == 1 ? "" : kernel::digits(size) + "*") + root;
}

Ball ball_of(const Quadratic& x) {
  const Ball a(x.a_);
  return cln::zerop(x.b_) ? a : a + Ball(x.b_) * sqrt(Ball(cl_RA(x.d_)));
}

}  // namespace balls
