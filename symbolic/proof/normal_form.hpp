// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>

#include "magicmass/errors.hpp"
#include "proof/definitions.hpp"
#include "proof/domain.hpp"

namespace magicmass::proof {

/// The expression is outside the class that the normal form decides.
struct NotInClass : Undecided {
  using Undecided::Undecided;
};

/// The exact algebraic normal form. An expression becomes a rational function of generators:
///   - symbols, and sequence elements such as a(n - 1);
///   - r = sqrt(p) for each irreducible p > 0 on the domain, with r^2 = p; p > 0 is proved and recorded;
///   - a pair (C, S) = (cos x, sin x) for each independent angle x, with C^2 + S^2 = 1;
///   - cos and sin of multiples of atan(t), of psi and theta and of halves of them: their algebraic values.
/// The numerator is reduced to be linear in every r and S. As no product of distinct irreducible p is a
/// square, and 1 - C^2 is none, the expression is identically zero exactly when that numerator is.
/// Elements of matrices are taken one by one.
class NormalForm {
public:
  /// For expressions whose names stand for these meanings.
  NormalForm(const Domain& domain, const Definitions& definitions);
  NormalForm(const NormalForm&) = delete;
  NormalForm(NormalForm&&) = delete;
  NormalForm& operator=(const NormalForm&) = delete;
  NormalForm& operator=(NormalForm&&) = delete;
  ~NormalForm();

  /// Throws NotInClass. Zero means: zero wherever the expression is defined; see conditions().
  bool is_zero(const GiNaC::ex& e);

  /// Collects the conditions under which e is defined. Throws NotInClass.
  void require_defined(const GiNaC::ex& e);

  /// Whether both are equal wherever both are defined; each is translated by itself, for GiNaC drops poles
  /// that both have.
  bool are_equal(const GiNaC::ex& left, const GiNaC::ex& right);

  /// An equal expression, cancelled and collected: what a derivation writes down as its result.
  GiNaC::ex simplified(const GiNaC::ex& e);

  /// Whether e > 0 follows from the domain by signs of factors and coefficients alone; false: not seen.
  bool is_positive(const GiNaC::ex& e);

  /// Whether e >= 0 follows in the same way.
  bool is_not_negative(const GiNaC::ex& e);

  /// Every assumption used so far, and every "d != 0" needed but not seen to follow from the domain.
  const Conditions& conditions() const;

private:
  class Generators;
  std::unique_ptr<Generators> generators_;
};

}  // namespace magicmass::proof
