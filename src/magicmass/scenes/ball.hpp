// SPDX-License-Identifier: GPL-2.0-or-later
// Fixed-point balls: a midpoint and a radius, both whole multiples of 2^-bits. What is exact lies
// within; for mass ratios that are no rationals.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <cln/integer.h>
#include <cln/rational.h>

namespace magicmass::scenes {

class Ball {
public:
  /// Contains q; the bits of what follows. One thread at a time.
  Ball(const cln::cl_RA& q = 0);
  Ball(int n) : Ball(cln::cl_RA(n)) {}
  Ball(std::int64_t n) : Ball(cln::cl_RA(static_cast<long long>(n))) {}
  explicit Ball(double finite);

  static void set_bits(int bits);  ///< of all balls from now on; no older one may be used again
  static Ball pi();
  friend Ball cos(const Ball& x);  ///< |x| at most 8
  friend Ball sin(const Ball& x);  ///< |x| at most 8
  friend Ball atan(const Ball& x);
  /// Throws Undecided where x may be negative.
  friend Ball sqrt(const Ball& x);
  /// Throws Undecided where there is a whole number within.
  friend Ball ceil(const Ball& x);
  /// Throw Undecided where neither is certain.
  friend bool operator<=(const Ball& a, const Ball& b);
  friend bool operator>=(const Ball& a, const Ball& b) { return b <= a; }
  friend bool operator<(const Ball& a, const Ball& b) { return !(b <= a); }
  friend bool operator>(const Ball& a, const Ball& b) { return !(a <= b); }
  friend Ball operator+(const Ball& a, const Ball& b);
  friend Ball operator-(const Ball& a, const Ball& b);
  friend Ball operator*(const Ball& a, const Ball& b);
  /// Throws Undecided where b may be 0.
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
  static int bits_;
  cln::cl_I middle;
  cln::cl_I radius;
};

/// Calls with more and more bits until it says that all is certain; throws Undecided, so
/// many "bits would be needed" and `otherwise`, where that is not so with many times the bits of
/// `digits` decimal digits.
void with_bits(int digits, const std::function<bool()>& is_certain, const std::string& otherwise);

/// The double nearest to every number from low to high, ties to even; nothing where they differ.
std::optional<double> nearest_double(const cln::cl_RA& low, const cln::cl_RA& high);
/// "0.2360679775": so many significant digits, rounded to nearest; nothing where they differ
/// between low and high, or where 0 is between them and they are not both 0.
std::optional<std::string> decimal(const cln::cl_RA& low, const cln::cl_RA& high, int digits);

/// A finite double, exactly.
cln::cl_RA exact(double value);

}  // namespace magicmass::scenes
