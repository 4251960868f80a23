// SPDX-License-Identifier: GPL-2.0-or-later
// What the chapters of evaluated forms share: names for parts of a form, the angle.
#pragma once
#include "derivation/symbols.hpp"

namespace derivation {
inline Expr of_alpha(const std::string& name) { return fun(name, {alpha}); }

/// half_h = psi/4, t = sin(psi/4)/cos(psi/4), t <= w, and rules for forms in t and w = t/alpha.
struct Angle {
  Theorem quarter, tangent, t_small;
  Theorems rules;
};

/// The terminal velocities, from what is left of a quarter turn after N_A steps of psi/2.
void terminal_forms(Book& book, const Angle& a);
/// When and where collision j takes place, from the sine and cosine of j psi/4.
void collision_forms(Book& book, const Angle& a);
}  // namespace derivation
