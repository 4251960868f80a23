// SPDX-License-Identifier: GPL-2.0-or-later
// Sums of products of cosines and real radicals, multiplied out.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "algebraic/budget.hpp"
#include "algebraic/interval.hpp"
#include "algebraic/root_sum.hpp"

namespace magicmass::algebraic {

/// Numbers made of the m-th roots of unity and of generators, real numbers g > 0 with g^index equal to an earlier number.
/// All operations spend the budget of terms and throw BeyondBudget after it.
class RadicalRing {
public:
  /// Exponents of the generators, without zeros at the end.
  using Monomial = std::vector<long>;
  /// Coefficients of monomials. Each is a real number; one that is written differently may still be 0.
  using Number = std::map<Monomial, RootSum>;

  RadicalRing(long order_of_roots, const Work& work) : work_(work), roots_(order_of_roots) {}

  const RootsOfUnity& roots() const { return roots_; }
  std::size_t generators() const { return generators_.size(); }

  static Number number(const cln::cl_RA& value);
  Number cosine(const cln::cl_RA& turn) const { return {{Monomial{}, roots_.cosine(turn)}}; }
  /// The real g > 0 with g^index = power > 0; a generator is made once.
  std::size_t generator(long index, const Number& power);
  /// g^exponent factor, 0 <= exponent < index.
  static Number power_of_generator(std::size_t generator, long exponent, const cln::cl_RA& factor);

  static Number sum(Number x, const Number& y);
  Number product(const Number& x, const Number& y);
  Number power(Number x, cln::cl_I n);

  Interval enclosure(const Number& x, long precision) const;

  /// -1 or +1 if intervals of moderate precision show it.
  std::optional<int> sign_of_nonzero(const Number& x) const;

  /// Whether x is 0, proved either way; nothing where this method does not tell.
  std::optional<bool> is_zero(const Number& x);

private:
  struct Generator {
    long index;
    Number power;
  };

  Number product_of_monomials(const Monomial& x, const Monomial& y, const RootSum& coefficient);
  bool all_coefficients_vanish(const Number& x) const;

  const Work& work_;
  RootsOfUnity roots_;
  std::vector<Generator> generators_;
  long spent_ = 0;
};

}  // namespace magicmass::algebraic
