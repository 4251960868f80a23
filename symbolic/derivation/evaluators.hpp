// SPDX-License-Identifier: GPL-2.0-or-later
// What the chapters of evaluated forms share: names for parts of a form, the angle, a prover.
#pragma once
#include "derivation/symbols.hpp"

namespace derivation {
inline Expr of_alpha(const std::string& name) { return fun(name, {alpha}); }
inline Expr of_both(const std::string& name) { return fun(name, {alpha, n}); }

/// half_h = psi/4, t = sin(psi/4)/cos(psi/4), w = t/alpha, t <= w.
struct Angle {
  Theorem quarter, tangent, t_is, w_is, t_small;
};

/// Proves that a velocity is a form in t, w and a sine and cosine.
struct Prover {
  Theorems rules;

  Prover(Book& book, const Angle& a) {
    const Expr root = sqrt(alpha * (2 + alpha)), q = psi() / 4;
    rules = {a.w_is, a.tangent, part(book["power.quarter"], 1), part(book["power.quarter"], 2),
             book["power.V_CM"]};
    const auto rationalised = [&](Expr l, Expr r) {
      return cancel(eq(l, r), {positive(cos(q))}, rules + angles({}, {q}));
    };
    rules = rules + Theorems{rationalised(root * sin(q), alpha * cos(q)),
                             rationalised(root * cos(q), (2 + alpha) * sin(q))};
  }
  Theorem equal(Expr l, Expr r, const Theorems& more, const Exprs& bases) const {
    const Theorem cosine = positive(cos(psi() / 4));
    return cancel(eq(l, r), {cosine, cosine}, more + rules, bases);
  }
};

/// The terminal velocities, from what is left of a quarter turn after N_A steps of psi/2.
void terminal_forms(Book& book, const Angle& a);
/// When and where collision j takes place, from the sine and cosine of j psi/4.
void collision_forms(Book& book, const Angle& a);
}  // namespace derivation
