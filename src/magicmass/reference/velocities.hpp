// SPDX-License-Identifier: GPL-2.0-or-later
// The oracle for a_n, b_n, c_n and c'_n. It knows the collision law and nothing else: the velocities after n cycles
// are the n-th power of one cycle's map, which is linear, so its columns are one cycle's outcome for unit vectors.
#pragma once

#include <string>

#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/reference/enclosure.hpp"
#include "magicmass/scenes/mass_ratio.hpp"

namespace magicmass::reference {

/// a_n, b_n, c_n, c'_n in units of V. For n = 0 these are the initial values 1, 0, 0, 0.
template <class Value>
struct CycleVelocities {
  Value a;        ///< of A just after P_n
  Value b;        ///< of B just after Q_n
  Value c;        ///< of C just after P_n
  Value c_prime;  ///< of C just after Q_n

  /// All four are equal.
  friend bool operator==(const CycleVelocities&, const CycleVelocities&) = default;
};

/// Longest exact velocity computed, in bits of its denominator: about two seconds of work, 300 000 digits.
inline constexpr long longest_exact_velocity = 1L << 20;

/// Exact, for rational alpha > 0 and n >= 0, also beyond the last collision, where the formula goes on and physics
/// does not. Numerators grow with n, but for alpha = 1, by about twice the length of alpha a cycle: throws Undecided
/// past longest_exact_velocity; InvalidInput for alpha <= 0 or n < 0.
CycleVelocities<cln::cl_RA> exact_velocities(const cln::cl_RA& alpha, const cln::cl_I& n);

/// Enclosures of the four velocities at one precision; the cost grows with log n only.
/// Throws InvalidInput for n < 0; Undecided if the precision cannot tell 1 + alpha from 0.
CycleVelocities<Interval> enclosed_velocities(const Enclosure& alpha, const cln::cl_I& n,
                                              long precision);

/// Rationals with relative error below 2^-bits each; an exact zero of a rational alpha is 0.
/// Throws Undecided where a velocity could not be told from zero: an exact zero at an irrational alpha (such as
/// a_k and c'_k at magic:k) has a cause that no number of digits shows. InvalidInput as above and for bits < 1.
CycleVelocities<cln::cl_RA> velocities_within(const MassRatio& alpha, const cln::cl_I& n,
                                              long bits);

/// Each velocity rounded to `digits` >= 1 significant decimal digits, every digit certain, in to_decimal's form.
/// Throws as velocities_within.
CycleVelocities<std::string> certified_digits(const MassRatio& alpha, const cln::cl_I& n,
                                              int digits);

}  // namespace magicmass::reference
