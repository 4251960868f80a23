// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>

#include <cln/rational.h>

namespace magicmass::algebraic {

/// The number sum of coefficient exp(2 pi i exponent/m), 0 <= exponent < m; the coefficients are not 0.
using RootSum = std::map<long, cln::cl_RA>;

/// Arithmetic with the m-th roots of unity, never writing out more than the sums at hand: m may be large.
class RootsOfUnity {
public:
  /// 1 <= m < 2^40
  explicit RootsOfUnity(long m);

  long order() const { return m_; }
  static RootSum number(const cln::cl_RA& value);
  /// cos(2 pi turn), where m turn is an integer.
  RootSum cosine(const cln::cl_RA& turn) const;
  RootSum product(const RootSum& x, const RootSum& y) const;
  static void add(RootSum& x, const RootSum& y);

  /// Whether the sum is the number 0, decided exactly.
  bool vanishes(const RootSum& x) const;

private:
  long m_;
  std::map<long, long> factors_;  ///< prime -> exponent
};

}  // namespace magicmass::algebraic
