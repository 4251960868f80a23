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

  std::size_t degree() const { return minimal_.size() - 1; }
  const std::string& name() const { return name_; }
  const std::vector<cln::cl_I>& minimal() const { return minimal_; }
  /// Enclosures of 1, y, ..., y^(d-1).
  std::vector<Interval> powers(long precision) const;

private:
  std::vector<cln::cl_I> minimal_;
  Enclosure generator_;
  std::string name_;
};

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
  FieldNumber(
      int value = 0);  // NOLINT(google-explicit-constructor): the literals of the collision law
  FieldNumber(const cln::cl_RA& value);  // NOLINT(google-explicit-constructor)
  FieldNumber(FieldPointer field, std::vector<cln::cl_RA> coefficients);

  bool is_rational() const { return coefficients_.size() == 1; }
  const cln::cl_RA& rational() const { return coefficients_.front(); }  ///< of a rational one
  const std::vector<cln::cl_RA>& coefficients() const { return coefficients_; }
  int sign() const;  ///< exactly
  /// Contains it, and is at most 2^(4-precision) times 1 + |x| wide.
  Interval enclosed(long precision) const;
  /// Length of the longest coefficient.
  long bits() const;

  friend FieldNumber operator+(const FieldNumber& x, const FieldNumber& y);
  friend FieldNumber operator-(const FieldNumber& x, const FieldNumber& y);
  friend FieldNumber operator*(const FieldNumber& x, const FieldNumber& y);
  friend FieldNumber operator/(const FieldNumber& x, const FieldNumber& y);
  friend bool operator<(const FieldNumber& x, const FieldNumber& y) { return (x - y).sign() < 0; }
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
extern template double nearest(const FieldNumber&);
extern template long double nearest(const FieldNumber&);
inline double nearest_double(const FieldNumber& x) { return nearest<double>(x); }
/// "p/q", or a sum like "-2 + y" in the field's generator.
std::string to_text(const FieldNumber& x);

}  // namespace magicmass::reference
