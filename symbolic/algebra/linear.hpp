// SPDX-License-Identifier: GPL-2.0-or-later
// Inequalities by linear combination.
#pragma once
#include "algebra/logic.hpp"

namespace algebra {
/// `goal` (=, <, <= or not =) as a linear combination of `facts` (=, <, <=), each monomial an
/// unknown; the combination is found by Fourier's and Motzkin's elimination. Throws Refused where
/// there is none.
Theorem linear(Expr goal, const Theorems& facts);
}  // namespace algebra
