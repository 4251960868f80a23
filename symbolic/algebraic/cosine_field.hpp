// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "algebraic/polynomial.hpp"

namespace magicmass::algebraic {

/// The field Q(y) of y = 2 cos(2 pi/m), m > 4: its elements as coefficients of 1, y, ..., y^(d-1), its automorphisms
/// as the numbers j, 0 < j < m/2 and prime to m, that take y to 2 cos(2 pi j/m).
class CosineField {
public:
  using Element = std::vector<cln::cl_RA>;

  explicit CosineField(long m);

  const std::vector<long>& automorphisms() const { return automorphisms_; }

  Element number(const cln::cl_RA& value) const;
  const Element& generator() const { return powers_[1]; }
  Element generator_inverse() const;
  Element image(long automorphism, const Element& x) const;
  Element product(const Element& x, const Element& y) const;
  /// a x + b y
  static Element combination(const cln::cl_RA& a, const Element& x, const cln::cl_RA& b,
                             const Element& y);

  /// Of x as a real number, which is not 0.
  int sign(const Element& x) const;

private:
  long representative(long j) const;

  long m_;
  Polynomial minimal_;
  std::vector<long> automorphisms_;
  std::vector<Element> powers_;  ///< y^i for i < 2 d
  std::vector<Element> images_;  ///< 2 cos(2 pi j/m), the j of automorphisms_
};

}  // namespace magicmass::algebraic
