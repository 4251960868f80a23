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
/// From the chapter "evaluators".
Angle evaluated_angle(const Book& book);
}  // namespace derivation
