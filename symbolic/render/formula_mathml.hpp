// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "render/formula.hpp"

namespace magicmass::render {

/// A `math` element for within a line of words.
std::string mathml(const Formula& formula);

/// An equation as `math` elements between which a narrow page may break the line.
std::string mathml_display(const Formula& equation);

/// Any characters as HTML or XML text or attribute; what XML cannot hold is left out.
std::string html_escaped(std::string_view text);

}  // namespace magicmass::render
