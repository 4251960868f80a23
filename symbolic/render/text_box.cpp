// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/text_box.hpp"

#include <algorithm>
#include <array>

namespace magicmass::render {
namespace {

std::string blanks(std::size_t count) { return std::string().append(count, ' '); }

std::string padded(const std::string& row, std::size_t width) {
  const std::size_t own = columns(row);
  return own < width ? row + blanks(width - own) : row;
}

std::string centred(const std::string& row, std::size_t width) {
  const std::size_t own = columns(row);
  return padded(own < width ? blanks((width - own) / 2) + row : row, width);
}

/// A bracket's pieces: for one row, then top, middle and bottom of several.
struct Pieces {
  const char* single;
  const char* top;
  const char* middle;
  const char* bottom;
};

std::pair<Pieces, Pieces> pieces(Bracket bracket, bool unicode) {
  switch (bracket) {
    case Bracket::round:
      if (unicode) return {{"(", "⎛", "⎜", "⎝"}, {")", "⎞", "⎟", "⎠"}};
      return {{"(", "/", "|", "\\"}, {")", "\\", "|", "/"}};
    case Bracket::square:
      if (unicode) return {{"[", "⎡", "⎢", "⎣"}, {"]", "⎤", "⎥", "⎦"}};
      return {{"[", "[", "[", "["}, {"]", "]", "]", "]"}};
    case Bracket::bar:
      break;
  }
  const char* bar = unicode ? "│" : "|";
  return {{"|", bar, bar, bar}, {"|", bar, bar, bar}};
}

TextBox bracket_box(const Pieces& shape, std::size_t height, std::size_t baseline) {
  if (height == 1) return line_box(shape.single);
  TextBox box{{shape.top}, baseline};
  for (std::size_t i = 2; i < height; ++i) box.rows.emplace_back(shape.middle);
  box.rows.emplace_back(shape.bottom);
  return box;
}

}  // namespace

std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;  // not a continuation of UTF-8
  }));
}

TextBox line_box(std::string text) { return {{std::move(text)}, 0}; }

TextBox beside(const std::vector<TextBox>& boxes) {
  std::size_t above = 0;
  std::size_t below = 0;
  for (const TextBox& box : boxes) {
    above = std::max(above, box.baseline);
    below = std::max(below, box.height() - box.baseline);
  }
  TextBox result{std::vector<std::string>(above + below), above};
  for (const TextBox& box : boxes)
    for (std::size_t row = 0; row < result.rows.size(); ++row) {
      const std::size_t first = above - box.baseline;
      const bool inside = row >= first && row < first + box.height();
      result.rows[row] += inside ? box.rows[row - first] : blanks(box.width());
    }
  return result;
}

TextBox fraction(const TextBox& above, const TextBox& below, const std::string& bar) {
  const std::size_t width = std::max(above.width(), below.width()) + 2;
  TextBox result{{}, above.height()};
  for (const std::string& row : above.rows) result.rows.push_back(centred(row, width));
  std::string line;
  for (std::size_t i = 0; i < width; ++i) line += bar;
  result.rows.push_back(line);
  for (const std::string& row : below.rows) result.rows.push_back(centred(row, width));
  return result;
}

TextBox grid(const std::vector<TextBox>& cells, std::size_t columns) {
  std::vector<std::size_t> widths(columns, 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
    widths[i % columns] = std::max(widths[i % columns], cells[i].width());
  TextBox result;
  for (std::size_t first = 0; first < cells.size(); first += columns) {
    std::vector<TextBox> row;
    for (std::size_t column = 0; column < columns; ++column) {
      TextBox cell = cells[first + column];
      for (std::string& line : cell.rows)
        line = padded(line, widths[column] + (column + 1 < columns ? 2 : 0));
      row.push_back(std::move(cell));
    }
    const TextBox line = beside(row);
    if (line.height() > 1 && first > 0) result.rows.push_back(blanks(line.width()));
    result.rows.insert(result.rows.end(), line.rows.begin(), line.rows.end());
  }
  result.baseline = (result.height() - 1) / 2;
  return result;
}

TextBox surrounded(const TextBox& inside, Bracket bracket, bool unicode) {
  const auto [left, right] = pieces(bracket, unicode);
  return beside({bracket_box(left, inside.height(), inside.baseline), inside,
                 bracket_box(right, inside.height(), inside.baseline)});
}

}  // namespace magicmass::render
