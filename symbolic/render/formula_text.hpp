// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "render/formula.hpp"
#include "render/text_box.hpp"

namespace magicmass::render {

/// What a terminal can show.
struct TextStyle {
  bool unicode = false;    ///< UTF-8, not ASCII alone
  bool colourful = false;  ///< escape sequences for colours
};

/// On one line: "cₙ = V_CM (1 + sin[(n − ¼)ψ]/sin(ψ/4))", or the kernel's own text where Unicode is not wanted.
std::string inline_text(const Formula& formula, const TextStyle& style);

/// An equation as lines of at most 80 columns, indented; two-dimensional where it fits: fractions of more than numbers
/// over several lines, matrices in tall brackets.
std::string display_text(const Formula& equation, const TextStyle& style, std::size_t indent);

}  // namespace magicmass::render
