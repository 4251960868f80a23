// SPDX-License-Identifier: GPL-2.0-or-later
// Sines and cosines of integer combinations of angles.
#pragma once
#include "algebra/logic.hpp"

namespace algebra {
/// Rules for `equation`: each sine and cosine in `terms` in those of `bases`, by the addition
/// theorems, if its angle is a combination of them with integer coefficients; where `circle` is
/// true, also sin^2 = 1 - cos^2 of each base.
Theorems angles(const Exprs& terms, const Exprs& bases, bool circle = true);
/// p = q from cos(p) = cos(q), as the cosine falls from 0 to pi: `linear` finds p and q there.
Theorem same_angle(const Theorem& cosines, const Theorems& facts = {});
/// cos(q) < cos(p) from p < q, <= from p <= q: `linear` finds 0 <= p and q <= pi.
Theorem cosine_falls(const Theorem& less, const Theorems& facts = {});
/// 0 <= sin(t): `linear` finds 0 <= t and t <= pi.
Theorem sine_not_negative(Expr t, const Theorems& facts = {});
/// 0 < t and t < pi/2 give 0 < cos(t).
Theorem cosine_positive(const Theorem& from, const Theorem& below);
}  // namespace algebra
