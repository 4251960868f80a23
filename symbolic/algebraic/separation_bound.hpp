// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "algebraic/terms.hpp"

namespace magicmass::algebraic {

/// What a term, if it is not 0, is at least in absolute value: 2^-bits.
struct SeparationBound {
  double bits;
  double degree;  ///< the field that it lies in has at most this degree over the rational numbers
};

/// Burnikel, Funke, Mehlhorn, Schirra, Schmitt, "A separation bound for real algebraic expressions" (2009), with one
/// cyclotomic field for all cosines. Nothing where it would be astronomic.
std::optional<SeparationBound> separation_bound(const Terms& terms, std::size_t id,
                                                const Budget& budget);

/// phi(m), the number of units modulo m >= 1, as a number not below it where m is too large to factor.
double totient_bound(const cln::cl_I& m);

}  // namespace magicmass::algebraic
