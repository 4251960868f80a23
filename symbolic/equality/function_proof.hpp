// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "equality/point.hpp"

namespace magicmass::equality {

// Proofs that two functions agree at every point of the domain where both are defined: the method as a sentence, or
// nothing where none was found.

// The difference in the kernel's normal form is 0. Where cos(n pi/3), (-1)^n and the like are in it, for each residue
// of n by itself.
std::optional<std::string> by_normal_form(const Tree& lhs, const Tree& rhs, const Domain& domain);

// All derivatives of the difference vanish and it is 0 at one of the points; both sides are analytic on the domain's
// interior, which is connected.
std::optional<std::string> by_derivative(const Tree& lhs, const Tree& rhs, const Domain& domain,
                                         const std::vector<Point>& points);

// Inverse trigonometric functions inside cos, sin and tan are multiples of one of them, each by_derivative(); with
// these put in, by_normal_form().
std::optional<std::string> by_unified_angles(const Tree& lhs, const Tree& rhs, const Domain& domain,
                                             const std::vector<Point>& points);

}  // namespace magicmass::equality
