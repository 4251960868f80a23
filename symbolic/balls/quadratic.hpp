// SPDX-License-Identifier: GPL-2.0-or-later
// Exact numbers a + b sqrt(d) of one quadratic field; rationals are those with b = 0.
#pragma once

#include <optional>
#include <string>

#include <cln/rational.h>

#include "balls/ball.hpp"

namespace balls {

class Quadratic {
public:
  Quadratic(const cln::cl_RA& rational = 0) : a_(rational), b_(0), d_(1) {}
  Quadratic(int whole) : Quadratic(cln::cl_RA(whole)) {}
  /// The double itself. It must be finite.
  explicit Quadratic(double value);

  /// What leaves the field throws std::domain_error: two different square roots in one number, a
  /// division by 0, and a root of what is negative or has a root itself.
  static Quadratic sqrt(const Quadratic& x);
  friend Quadratic operator+(const Quadratic& x, const Quadratic& y);
  friend Quadratic operator-(const Quadratic& x, const Quadratic& y);
  friend Quadratic operator*(const Quadratic& x, const Quadratic& y);
  friend Quadratic operator/(const Quadratic& x, const Quadratic& y);
  friend bool operator<(const Quadratic& x, const Quadratic& y) { return compared(x, y) < 0; }
  friend bool operator==(const Quadratic& x, const Quadratic& y) { return compared(x, y) == 0; }

  /// d; 1 for a rational.
  const cln::cl_I& radicand() const { return d_; }
  /// Bits of the numerators and denominators.
  std::size_t bits() const;
  /// Nearest double, or one next to it; nothing where that is infinite or subnormal.
  std::optional<double> to_double() const;
  /// "-1/4", "-2+sqrt(5)", "1/2-1/2*sqrt(5)"
  std::string text() const;

  /// Contains x.
  friend Ball ball_of(const Quadratic& x);

private:
  cln::cl_RA a_, b_;
  cln::cl_I d_;  // no square of a small prime divides it; 1 where b = 0

  Quadratic(const cln::cl_RA& a, const cln::cl_RA& b, const cln::cl_I& d);
  int sign() const;
  static int compared(const Quadratic& x, const Quadratic& y);
  static const cln::cl_I& common(const Quadratic& x, const Quadratic& y);
};

}  // namespace balls
