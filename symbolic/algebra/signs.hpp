// SPDX-License-Identifier: GPL-2.0-or-later
// Signs of terms from their shape.
#pragma once
#include "algebra/logic.hpp"

namespace algebra {
/// |- 0 < t: numbers, sums, products, powers, quotients, roots, pi and arctangents of positive
/// terms; `facts` say the rest. Throws Refused where the shape of t does not show it.
Theorem positive(Expr t, const Theorems& facts = {});
/// |- 0 <= t
Theorem not_negative(Expr t, const Theorems& facts = {});
/// p < q gives not q - p = 0.
Theorem not_zero(const Theorem& less);
/// 0 < (q - p)(s - r) from p < q and r < s, 0 <= where one of them is <=.
Theorem times(const Theorem& a, const Theorem& b);
}  // namespace algebra
