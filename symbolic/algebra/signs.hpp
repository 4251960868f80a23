// SPDX-License-Identifier: GPL-2.0-or-later
// Signs of terms from their shape.
#pragma once
#include <optional>

#include "algebra/logic.hpp"

namespace algebra {
/// |- 0 < l from l = r, where that shows 0 < r.
Theorem positive(const Theorem& is, const Theorems& facts = {});
/// |- 0 < t: numbers, sums, products, powers, quotients, roots, pi and arctangents of positive
/// terms, sines of angles below pi, cosines of those below pi/2; `facts`, what is known and
/// `linear` say the rest. Throws Refused where nothing shows it.
Theorem positive(Expr t, const Theorems& facts = {});
/// |- 0 <= t
Theorem not_negative(Expr t, const Theorems& facts = {});
/// |- 0 < t or |- 0 <= t, or nothing.
std::optional<Theorem> sign_of(Expr t, const Theorems& facts = {}, bool strict = true);
/// 0 < (q - p)(s - r)... from p < q, r < s, ..., 0 <= where one of them is <=.
Theorem product_of(const Theorems& factors);
Theorem times(const Theorem& a, const Theorem& b);
/// The same for a term that is `positive`.
Theorem times(const Theorem& a, Expr positive_term);
}  // namespace algebra
