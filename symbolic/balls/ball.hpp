// SPDX-License-Identifier: GPL-2.0-or-later
// Fixed-point balls: a midpoint and a radius, both whole multiples of 2^-bits. What is exact lies
// within. One ball type serves scenes, certified digits and the decision of equality. And exact
// numbers with one square root.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include <cln/integer.h>
#include <cln/rational.h>

namespace balls {

/// What was asked of balls is not certain with these bits.
struct NotCertain : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A finite double, exactly.
cln::cl_RA exact(double value);

class Ball {
public:
  /// Contains q; the bits of what follows. One thread at a time.
  Ball(const cln::cl_RA& q = 0);
  Ball(int n) : Ball(cln::cl_RA(n)) {}
  Ball(std::int64_t n) : Ball(cln::cl_RA(static_cast<long long>(n))) {}
  explicit Ball(double finite) : Ball(exact(finite)) {}

  static void set_bits(int bits);  ///< of all balls from now on; no older one may be used again
  static Ball pi();
  static int bits() { return bits_; }
  friend Ball cos(const Ball& x);  ///< without reduction: for |x| up to 8, say
  friend Ball sin(const Ball& x);
  /// Throws NotCertain where x may be above 10^5.
  friend Ball exp(const Ball& x);
  /// Throws NotCertain where x may not be positive.
  friend Ball log(const Ball& x);
  friend Ball atan(const Ball& x);
  /// exponent >= 0. Throws NotCertain where there may be more than 10^6 bits.
  friend Ball power(const Ball& base, std::int64_t exponent);
  /// Throws NotCertain where x may be negative.
  friend Ball sqrt(const Ball& x);
  /// Throws NotCertain where there is a whole number within.
  friend Ball ceil(const Ball& x);
  /// Throw NotCertain where neither is certain.
  friend bool operator<=(const Ball& a, const Ball& b);
  friend bool operator>=(const Ball& a, const Ball& b) { return b <= a; }
  friend bool operator<(const Ball& a, const Ball& b) { return !(b <= a); }
  friend bool operator>(const Ball& a, const Ball& b) { return !(a <= b); }
  friend Ball operator+(const Ball& a, const Ball& b);
  friend Ball operator-(const Ball& a, const Ball& b) { return a + -b; }
  friend Ball operator*(const Ball& a, const Ball& b);
  /// Throws NotCertain where b may be 0.
  friend Ball operator/(const Ball& a, const Ball& b);
  friend Ball operator-(const Ball& a) { return Ball(-a.middle, a.radius); }

  cln::cl_RA low() const;
  cln::cl_RA high() const;

private:
  Ball(const cln::cl_I& m, const cln::cl_I& r) : middle(m), radius(r) {}
  bool is_zero() const { return middle == 0 && radius == 0; }
  /// A part of it; as cheap as can be.
  Ball over(int n) const { return {cln::floor1(middle, n), cln::floor1(radius, n) + 2}; }
  static Ball alternating(Ball term, const Ball& square, int first);
  static Ball odd_powers(const Ball& t, const Ball& square);
  static int bits_;
  cln::cl_I middle;
  cln::cl_I radius;
};

/// The double nearest to every number from low to high, ties to even; nothing where they differ.
std::optional<double> nearest_double(const cln::cl_RA& low, const cln::cl_RA& high);
/// "0.2360679775": so many significant digits, rounded to nearest; nothing where they differ
/// between low and high, or where 0 is between them and they are not both 0.
std::optional<std::string> decimal(const cln::cl_RA& low, const cln::cl_RA& high, int digits);

/// a + b sqrt(d), of one quadratic field, exactly; rationals are those with b = 0.
class Quadratic {
public:
  Quadratic(const cln::cl_RA& rational = 0) : a_(rational), b_(0), d_(1) {}
  Quadratic(int whole) : Quadratic(cln::cl_RA(whole)) {}
  /// The double itself. It must be finite.
  explicit Quadratic(double value) : Quadratic(exact(value)) {}

  /// What leaves the field throws std::domain_error: two different square roots in one number, a
  /// division by 0, and a root of what is negative or has a root itself.
  static Quadratic sqrt(const Quadratic& x);
  friend Quadratic operator+(const Quadratic& x, const Quadratic& y);
  Quadratic operator-() const { return {-a_, -b_, d_}; }
  friend Quadratic operator-(const Quadratic& x, const Quadratic& y) { return x + -y; }
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
