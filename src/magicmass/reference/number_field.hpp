// SPDX-License-Identifier: GPL-2.0-or-later
// Exact arithmetic with one irrational number y: sums of rational multiples of 1, y, ..., y^(d-1).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/reference/enclosure.hpp"

namespace magicmass::reference {

/// Q(y), y a real root of a monic irreducible polynomial with whole coefficients.
class NumberField {
public:
  /// minimal: the polynomial's coefficients, constant first, the leading 1 last; generator: encloses y.
  NumberField(std::vector<cln::cl_I> minimal, Enclosure generator, std::string name);

  /// Of the minimal polynomial.
  std::size_t degree() const { return minimal_.size() - 1; }
  /// As it was made with: "Q(sqrt(5))".
  const std::string& name() const { return name_; }
  /// Of the minimal polynomial, constant first.
  const std::vector<cln::cl_I>& minimal() const { return minimal_; }
  /// Enclosures of 1, y, ..., y^(d-1).
  std::vector<Interval> powers(long precision) const;

private:
  std::vector<cln::cl_I> minimal_;
  Enclosure generator_;
  std::string name_;
};

/// Numbers share their field; null stands for the rationals.
using FieldPointer = std::shared_ptr<const NumberField>;

/// Q(sqrt(radicand)) for a squarefree radicand > 1; y is that root.
FieldPointer quadratic_field(const cln::cl_I& radicand);
/// Q(cos(pi/denominator)) for a denominator > 3, of degree phi(2 denominator)/2; y = 2 cos(pi/denominator).
FieldPointer cosine_field(std::int64_t denominator);
/// That degree, without making the field.
std::int64_t cosine_degree(std::int64_t denominator);

/// A real number of a field. Rationals belong to every field; numbers of two different fields do not mix.
class FieldNumber {
public:
  /// A whole number, of every field.
  FieldNumber(
      int value = 0);  // NOLINT(google-explicit-constructor): the literals of the collision law
  /// A rational number, of every field.
  FieldNumber(const cln::cl_RA& value);  // NOLINT(google-explicit-constructor)
  /// The sum of coefficient i times y^i; as many as the field's degree.
  FieldNumber(FieldPointer field, std::vector<cln::cl_RA> coefficients);

  /// No power of y is in it.
  bool is_rational() const { return coefficients_.size() == 1; }
  const cln::cl_RA& rational() const { return coefficients_.front(); }  ///< of a rational one
  /// Of 1, y, ..., y^(d-1); of a rational number one.
  const std::vector<cln::cl_RA>& coefficients() const { return coefficients_; }
  int sign() const;  ///< exactly
  /// Contains it, and is at most 2^(4-precision) times 1 + |x| wide.
  Interval enclosed(long precision) const;
  /// Length of the longest coefficient.
  long bits() const;

  /// Exact. Throws InvalidInput for numbers of two different fields, as do all below.
  friend FieldNumber operator+(const FieldNumber& x, const FieldNumber& y);
  /// Exact.
  friend FieldNumber operator-(const FieldNumber& x, const FieldNumber& y);
  /// Exact.
  friend FieldNumber operator*(const FieldNumber& x, const FieldNumber& y);
  /// Exact. Throws InvalidInput for y = 0.
  friend FieldNumber operator/(const FieldNumber& x, const FieldNumber& y);
  /// By the sign of the difference, exactly.
  friend bool operator<(const FieldNumber& x, const FieldNumber& y) { return (x - y).sign() < 0; }
  /// The same number, exactly.
  friend bool operator==(const FieldNumber& x, const FieldNumber& y);

private:
  FieldPointer field_;  // null for rationals
  std::vector<cln::cl_RA> coefficients_;

  FieldNumber inverse() const;
  void shorten();
};

/// The double or long double nearest to it.
template <class Float>
Float nearest(const FieldNumber& x);
/// One of its two instances.
extern template double nearest(const FieldNumber&);
/// One of its two instances.
extern template long double nearest(const FieldNumber&);
/// The double nearest to it.
inline double nearest_double(const FieldNumber& x) { return nearest<double>(x); }
/// "p/q", or a sum like "-2 + y" in the field's generator.
std::string to_text(const FieldNumber& x);

}  // namespace magicmass::reference
