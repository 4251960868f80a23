// SPDX-License-Identifier: GPL-2.0-or-later
// Inequalities by linear combination.
#pragma once
#include <optional>

#include "algebra/logic.hpp"

namespace algebra {
/// `goal` (=, also of matrices, <, <=, not =; several of them, or one that implies or is equivalent
/// to another) as a linear combination of `facts` (=, <, <=), each monomial an unknown; the
/// combination is found by Fourier's and Motzkin's elimination. Where they do not suffice: with
/// what is known, d/d = 1, squares of roots, the axioms of pi, ceilings and arctangents, i < j as i
/// + 1 <= j for integers, and the sign of the gap as `positive` sees it. Throws Refused where there
/// is none.
Theorem linear(Expr goal, const Theorems& facts = {});
/// `goal` from `relation`, which `linear` shows, times a positive factor.
Theorem scaled(Expr goal, Expr relation, Expr factor, const Theorems& facts = {});
/// An equivalence of two inequalities, of which the first is the second times a positive factor.
Theorem same_sign(Expr equivalence, Expr factor, const Theorems& facts);
/// An equation as a linear combination of equations and of nothing else, or nothing.
std::optional<Theorem> combination(Expr equation, const Theorems& equations);
/// As `linear` for one relation, but without the sign of the gap, or nothing.
std::optional<Theorem> linear_if(Expr goal, const Theorems& facts);
}  // namespace algebra
