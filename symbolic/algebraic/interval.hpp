// SPDX-License-Identifier: GPL-2.0-or-later
// Intervals whose ends are floating dyadic numbers m 2^e; every operation rounds outward, so the true value stays in.
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>

namespace magicmass::algebraic {

/// mantissa 2^exponent
struct Dyadic {
  cln::cl_I mantissa;  ///< m, of any length
  long exponent = 0;   ///< e

  /// -1, 0 or 1.
  int sign() const { return cln::minusp(mantissa) ? -1 : cln::zerop(mantissa) ? 0 : 1; }
  /// The least t with |value| <= 2^t; the value is not 0.
  long top() const;
  /// The same number.
  cln::cl_RA rational() const;
};

/// An operation has no bounded answer at this precision, because an operand may be 0 (or below it, for a root).
struct Unbounded {};

/// low <= x <= high, mantissas of at most `precision` bits after each operation.
class Interval {
public:
  /// The tightest enclosure with ends of so many bits.
  Interval(const cln::cl_RA& x, long precision);
  /// The tightest enclosure of [low, high] with such ends; low <= high.
  Interval(const cln::cl_RA& low, const cln::cl_RA& high, long precision);
  /// The whole of [low, high], ends rounded outward to `precision` bits.
  Interval(const Dyadic& low, const Dyadic& high, long precision);

  /// the lower end
  const Dyadic& low() const { return low_; }
  /// the upper end
  const Dyadic& high() const { return high_; }
  /// -1 or +1 if every member has that sign, 0 if all are the number 0; else nothing is certain: 2.
  int sign() const;
  /// The least t with |x| <= 2^t for every member; the members are not all 0.
  long top() const;

  Interval operator-() const;  ///< -x
  Interval magnitude() const;  ///< |x|

  /// x + y
  friend Interval sum(const Interval& x, const Interval& y, long precision);
  /// x y
  friend Interval product(const Interval& x, const Interval& y, long precision);
  /// Throws Unbounded if y may be 0.
  friend Interval quotient(const Interval& x, const Interval& y, long precision);
  /// x^n, n >= 1.
  friend Interval integer_power(const Interval& x, const cln::cl_I& n, long precision);

private:
  Interval(Dyadic low, Dyadic high);
  Dyadic low_;
  Dyadic high_;
};

/// As the member of that name.
Interval sum(const Interval& x, const Interval& y, long precision);
/// As the member of that name.
Interval product(const Interval& x, const Interval& y, long precision);
/// As the member of that name.
Interval quotient(const Interval& x, const Interval& y, long precision);
/// As the member of that name.
Interval integer_power(const Interval& x, const cln::cl_I& n, long precision);

/// x^(1/n) of the part of x that is >= 0, n >= 2. Throws Unbounded if there is none.
Interval real_root(const Interval& x, long n, long precision);

}  // namespace magicmass::algebraic
