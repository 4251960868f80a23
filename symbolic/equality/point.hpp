// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>

#include "equality/domain.hpp"
#include "equality/evaluate.hpp"

namespace magicmass::equality {

using Point = std::map<std::string, cln::cl_RA>;

std::string to_text(const Point& point);  // "alpha = 1/2, n = 3"

// The tree at a point, with rational numbers computed where that is possible and their size moderate.
Tree at(const Point& point, const Tree& tree);

// Points of the domain, the simplest first; each satisfies the further conditions of the domain, certainly.
std::vector<Point> points_of(const Domain& domain, std::size_t count, const ExactSign& exact_sign);

}  // namespace magicmass::equality
