// SPDX-License-Identifier: GPL-2.0-or-later
// Sines and cosines of integer combinations of angles.
#pragma once
#include "algebra/logic.hpp"

namespace algebra {
/// Rules for `equation`: each sine and cosine in `terms` in those of `bases`, by the addition
/// theorems; where `circle` is true, also sin^2 = 1 - cos^2 of each base. Throws Refused where an
/// angle is no combination of the bases with integer coefficients.
Theorems angles(const Exprs& terms, const Exprs& bases, bool circle = true);
/// p = q from cos(p) = cos(q), 0 <= p <= pi and 0 <= q <= pi (or <), as the cosine falls there.
Theorem same_angle(const Theorem& cosines, const Theorem& p_from, const Theorem& p_to,
                   const Theorem& q_from, const Theorem& q_to);
/// cos(q) < cos(p) from 0 <= p, p < q and q <= pi; <= from p <= q.
Theorem cosine_falls(const Theorem& from, const Theorem& less, const Theorem& to);
/// 0 <= sin(t) from 0 <= t and t <= pi.
Theorem sine_not_negative(const Theorem& from, const Theorem& to);
/// 0 < t and t < pi/2 give 0 < cos(t).
Theorem cosine_positive(const Theorem& from, const Theorem& below);
}  // namespace algebra
