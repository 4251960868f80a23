// SPDX-License-Identifier: GPL-2.0-or-later
// The mass ratios that the oracle answers for: rationals, and the paper's two families.
#pragma once

#include <functional>
#include <optional>

#include <cln/integer.h>
#include <cln/rational.h>

#include "magicmass/oracle/interval.hpp"

namespace magicmass::oracle {

/// alpha as a source of enclosures: called with a precision p it returns one of width <= 2^(3-p).
struct MassRatio {
  std::optional<cln::cl_RA> rational;      ///< the number itself, where it is one
  std::function<Interval(long)> enclosed;  ///< at a precision >= 1
  long length;                             ///< bits that it takes to tell alpha from 0 and infinity
};

/// A rational alpha > 0, else throws std::invalid_argument.
MassRatio ratio(const cln::cl_RA& alpha);
/// So many times as large; factor > 0.
MassRatio operator*(const MassRatio& alpha, const cln::cl_RA& factor);
/// The k-th magic mass ratio, k >= 1; the first is the number 1.
MassRatio magic(const cln::cl_I& k);
/// The k-th deficient mass ratio, k >= 1.
MassRatio deficient(const cln::cl_I& k);

}  // namespace magicmass::oracle
