// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace magicmass::render {

/// Any characters as Markdown text.
std::string markdown_escaped(std::string_view text);

/// Words with formulas between dollars.
std::string markdown_prose(const std::string& words);

}  // namespace magicmass::render
