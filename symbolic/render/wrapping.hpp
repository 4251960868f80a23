// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace magicmass::render {

/// Width of everything that is printed for reading.
inline constexpr std::size_t page_width = 80;

/// Words or a formula as lines of at most `width` columns, each ended by a line feed. The first begins with
/// `first`, the others with blanks of the same length. Breaks at blanks, else after a factor.
std::string wrapped(std::string_view text, std::string_view first, std::size_t width = page_width);

/// An equation as such lines, indented by `indent` blanks; a matrix [[..], [..]] gets a line a row.
std::string wrapped_equation(const std::string& from, const std::string& relation,
                             const std::string& to, std::size_t indent);

}  // namespace magicmass::render
