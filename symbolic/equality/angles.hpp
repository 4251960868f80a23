// SPDX-License-Identifier: GPL-2.0-or-later
// Inverse angles: 2 atan(x) and asin(2x/(1 + x^2)) are one angle up to whole turns, which one point
// decides.
#pragma once

#include "equality/normal_form.hpp"

namespace equality {
/// left - right, a sum of multiples of inverse angles and of pi, is 0: a multiple of it is a whole
/// number of turns in normal form, both sides are continuous all over the domain, which is
/// connected, and the difference is small at a point of `common`.
bool is_same_angle(Expr left, Expr right, const Domain& domain, const std::vector<Point>& common);
/// `right` with its inverse angles as multiples of those of `left`, where that is proved.
Expr with_one_angle(Expr left, Expr right, const Domain& domain, const std::vector<Point>& common);
}  // namespace equality
