// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "equality/domain.hpp"

namespace magicmass::equality {

// What must hold of `tree` for an expression to be defined.
struct Requirement {
  enum class Kind {
    nonzero,       // it is divided by
    not_negative,  // a root of even order, or 1 - u^2 for asin u and acos u
    positive,      // a logarithm, or a power with an exponent that is no number
    smooth,        // nothing, but where it is zero there is no derivative: abs, roots of odd order
  };
  Kind kind;
  Tree tree;
};

std::string to_text(const Requirement& requirement);  // "alpha - 1 != 0"

// All of them, each once. Those of constants are left out: whoever has a value at one point has seen them hold.
std::vector<Requirement> requirements(const Tree& tree);

// Those that do not follow from the domain by sign rules.
std::vector<Requirement> unproved(const std::vector<Requirement>& requirements,
                                  const Domain& domain);

// Whether every requirement holds with > in place of >= all over the domain's interior, so that the expression is
// analytic there; by sign rules.
bool is_analytic_inside(const std::vector<Requirement>& requirements, const Domain& domain);

// Whether each requirement that is no matter of a zero only has an equivalent one in the other list.
bool are_equivalent(const std::vector<Requirement>& left, const std::vector<Requirement>& right,
                    const Domain& domain);

}  // namespace magicmass::equality
