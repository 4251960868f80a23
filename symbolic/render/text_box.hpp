// SPDX-License-Identifier: GPL-2.0-or-later
// Rectangles of characters, put together to two-dimensional formulas.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace magicmass::render {

/// Columns that UTF-8 text takes: its code points.
std::size_t columns(std::string_view text);

/// Rows of one width; `baseline` is the row that stands on the line.
struct TextBox {
  std::vector<std::string> rows;  ///< from top to bottom
  std::size_t baseline = 0;       ///< counted from the top, 0 first

  /// Columns.
  std::size_t width() const { return rows.empty() ? 0 : columns(rows.front()); }
  /// Rows.
  std::size_t height() const { return rows.size(); }
};

/// One row.
TextBox line_box(std::string text);
/// Left to right, baselines on one line.
TextBox beside(const std::vector<TextBox>& boxes);
/// One above the other with a bar of `bar` between them.
TextBox fraction(const TextBox& above, const TextBox& below, const std::string& bar);
/// Columns aligned left, two blanks between them.
TextBox grid(const std::vector<TextBox>& cells, std::size_t columns);

/// What surrounds a box: (), [] or ||, as tall as it is.
enum class Bracket { round, square, bar };
/// In brackets of Unicode, or of plain characters.
TextBox surrounded(const TextBox& inside, Bracket bracket, bool unicode);

}  // namespace magicmass::render
