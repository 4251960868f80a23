// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "render/formula.hpp"

namespace magicmass::render {

/// For math mode, amsmath and amssymb loaded; fractions as fractions.
std::string latex(const Formula& formula);

/// About how wide that is set, in em.
double latex_width(const Formula& formula);

/// An equation for display math: on one line, or in `aligned` lines of at most `room` em.
std::string latex_display(const Formula& equation, double room);

/// Any characters as LaTeX text.
std::string latex_escaped(std::string_view text);

}  // namespace magicmass::render
