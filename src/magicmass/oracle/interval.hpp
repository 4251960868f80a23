// Intervals low/2^p <= x <= high/2^p; each operation rounds outward, so the true value stays in.
#pragma once

#include <stdexcept>

#include "magicmass/oracle/rational.hpp"

namespace magicmass::oracle {

/// The question has an answer, but not at the precision or size that the oracle goes to.
/// What the caller has wrong (alpha <= 0) is a std::invalid_argument.
class Undecided : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Of all members: zero means the number 0 alone, open that it is not the same for all.
enum class Sign { negative, zero, positive, open };

/// An enclosure of a real number. The result of an operation has the larger precision of its
/// operands, so the integers that constants are made of (precision 0, exact) fit in everywhere.
class Interval {
public:
  /// An exact integer.
  Interval(int value = 0);
  /// The tightest enclosure of x with ends that are multiples of 2^-precision; precision >= 0.
  Interval(const cl_RA& x, long precision);
  /// The tightest enclosure of [low, high] with such ends; low <= high.
  Interval(const cl_RA& low, const cl_RA& high, long precision);

  long precision() const { return precision_; }  ///< p: the ends are multiples of 2^-p
  cl_RA low() const;
  cl_RA high() const;
  Sign sign() const;

  /// Rounded outward, as are the others; division throws Undecided if y may be zero.
  friend Interval operator+(const Interval& x, const Interval& y);
  friend Interval operator-(const Interval& x, const Interval& y);
  friend Interval operator*(const Interval& x, const Interval& y);
  friend Interval operator/(const Interval& x, const Interval& y);

private:
  cl_I low_, high_;
  long precision_;

  Interval(const cl_I& low, const cl_I& high, long precision);
  /// The same interval with its ends written at a precision not below its own.
  Interval at(long precision) const;
};

}  // namespace magicmass::oracle
