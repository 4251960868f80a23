// Fixed-point balls: midpoint and radius, whole multiples of 2^-bits; what is exact lies within.
// One type serves scenes, certified digits and equality. And exact numbers with square roots.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

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

  static int bits;  ///< of all balls from now on; no older one may be used again
  static Ball pi();
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
  /// x^(1/n). Throws NotCertain where x may not be positive.
  friend Ball nth_root(const Ball& x, int n);
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
  double size() const;  ///< the greatest |x| within, rounded

private:
  Ball(const cln::cl_I& m, const cln::cl_I& r) : middle(m), radius(r) {}
  bool is_zero() const { return middle == 0 && radius == 0; }
  /// A part of it; as cheap as can be.
  Ball over(int n) const { return {cln::floor1(middle, n), cln::floor1(radius, n) + 2}; }
  static Ball over_factorials(Ball term, const Ball& square, int first);
  static Ball odd_powers(const Ball& t, const Ball& square);
  cln::cl_I middle, radius;
};

/// The double nearest to every number from low to high, ties to even; nothing where they differ.
std::optional<double> nearest_double(const cln::cl_RA& low, const cln::cl_RA& high);
/// "0.2360679775": so many significant digits, rounded to nearest; nothing where they differ
/// between low and high, or where 0 is between them and they are not both 0.
std::optional<std::string> decimal(const cln::cl_RA& low, const cln::cl_RA& high, int digits);

/// A surd: a sum of rational multiples of square roots of whole numbers, exactly.
class Surd {
public:
  Surd(const cln::cl_RA& rational = 0) : rational_(rational) {}
  Surd(int whole) : Surd(cln::cl_RA(whole)) {}
  explicit Surd(double finite) : Surd(exact(finite)) {}

  /// Throws std::domain_error for the root of what is negative or has a root itself.
  static Surd sqrt(const Surd& x);
  friend Surd operator+(const Surd& x, const Surd& y);
  Surd operator-() const { return Surd(-1) * *this; }
  friend Surd operator-(const Surd& x, const Surd& y) { return x + -y; }
  friend Surd operator*(const Surd& x, const Surd& y);
  /// Throws std::domain_error where y is 0.
  friend Surd operator/(const Surd& x, const Surd& y);
  friend bool operator<(const Surd& x, const Surd& y) { return compared(x, y) < 0; }
  friend bool operator==(const Surd& x, const Surd& y) { return compared(x, y) == 0; }

  /// Bits of the numerators and denominators.
  std::size_t bits() const;
  /// Nearest double, or one next to it; nothing where that is infinite or subnormal.
  std::optional<double> to_double() const;
  /// "-1/4", "-2+sqrt(5)", "1/2-1/2*sqrt(5)"
  std::string text() const;

  /// Contains x.
  friend Ball ball_of(const Surd& x);

private:
  cln::cl_RA rational_;
  // d, and the factor of sqrt(d), in the order of d. No square of a small prime divides it; the
  // product of two of them is no square: then these roots and 1 are linearly independent, and the
  // sum is 0 only without any.
  std::vector<std::pair<cln::cl_I, cln::cl_RA>> roots_;

  void add(const cln::cl_I& d, const cln::cl_RA& factor);
  cln::cl_RA near() const;
  static int compared(const Surd& x, const Surd& y);
};

}  // namespace balls
