// SPDX-License-Identifier: GPL-2.0-or-later
// What a value of a scene is worth, exactly.
#pragma once

#include <cstdint>
#include <vector>

#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/reference/number_field.hpp"
#include "magicmass/scenes/value.hpp"

namespace magicmass::reference {

/// rational + root sqrt(radicand); or, where secant_of > 0, sec(pi/secant_of) - 1.
struct ExactValue {
  cln::cl_RA rational = 0;     ///< the part without a root
  cln::cl_RA root = 0;         ///< what the root is multiplied by
  cln::cl_I radicand = 0;      ///< squarefree and above 1, or 0 together with root
  std::int64_t secant_of = 0;  ///< more than 3, or 0: magic:1 is the rational 1

  /// Neither a root nor a secant.
  bool is_rational() const { return secant_of == 0 && cln::zerop(root); }
};

/// Throws InvalidInput where the value is too large, divides by zero or has two different square roots.
ExactValue exact_value(const Value& value);

/// A common field of many values. Values that have none of degree at most `most` leave it without.
struct CommonField {
  bool exists = false;                  ///< there is a field of that degree at most
  FieldPointer field;                   ///< null for rationals
  std::int64_t cosine_denominator = 0;  ///< of its cosine, or 0
};
/// The field of least degree that has all values.
CommonField common_field(const std::vector<ExactValue>& values, std::int64_t most);

/// A value as a number of a field that was made for it.
FieldNumber in_field(const ExactValue& value, const CommonField& field);

/// By itself.
Enclosure enclosure(const ExactValue& value);
/// The double or long double nearest to it.
template <class Float>
Float nearest(const ExactValue& value);
/// One of its two instances.
extern template double nearest(const ExactValue&);
/// One of its two instances.
extern template long double nearest(const ExactValue&);
/// The double nearest to it.
inline double nearest_double(const ExactValue& value) { return nearest<double>(value); }
/// -1, 0 or 1, decided exactly.
int sign(const ExactValue& value);

}  // namespace magicmass::reference
