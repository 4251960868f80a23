// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace magicmass::render {

/// Width of everything that is printed for reading.
inline constexpr std::size_t page_width = 80;

/// A blank that no line ends at; wrapped() makes a blank of it.
inline constexpr char held_blank = '\x1f';

/// Words or a formula as lines of at most `width` columns (code points of UTF-8), each ended by a line feed. The first begins with
/// `first`, the others with blanks of the same length. Breaks at blanks, else after a factor.
std::string wrapped(std::string_view text, std::string_view first, std::size_t width = page_width);

/// Sentences with short formulas in them, broken between words and not at operators: "n = 1" stays together.
std::string wrapped_sentences(std::string_view text, std::string_view first,
                              std::size_t width = page_width);

}  // namespace magicmass::render
