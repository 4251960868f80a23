// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/wrapping.hpp"

#include <algorithm>

#include "render/text_box.hpp"

namespace magicmass::render {
namespace {

std::string blanks(std::size_t count) { return std::string().append(count, ' '); }

/// + - = − ≤ ... at the front, with a blank behind.
bool starts_with_operator(std::string_view text) {
  for (const std::string_view sign : {"+ ", "- ", "= ", "< ", "> ", "− ", "≤ ", "≥ ", "≠ "})
    if (text.starts_with(sign)) return true;
  return false;
}

/// Bytes of the first `room` characters.
std::size_t bytes_of(std::string_view text, std::size_t room) {
  std::size_t bytes = 0;
  for (std::size_t used = 0; bytes < text.size(); ++bytes) {
    if ((static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) continue;
    if (used++ == room) break;
  }
  return bytes;
}

/// Where to end a line that starts at text[0] and has room for `room_in_columns`: at the blank that is within the
/// fewest brackets, rather before an operator than elsewhere, never behind one, the last of these; else after a
/// factor. In bytes.
std::size_t line_end(std::string_view text, std::size_t room_in_columns) {
  if (columns(text) <= room_in_columns) return text.size();
  const std::size_t room = bytes_of(text, room_in_columns);
  std::size_t best = 0;
  int best_cost = 0;
  int depth = 0;
  bool behind_operator = false;
  for (std::size_t i = 0; i <= room; ++i) {
    if (text[i] == '(' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == ']') --depth;
    if (text[i] != ' ') continue;
    const bool before_operator = starts_with_operator(text.substr(i + 1));
    const int cost = 2 * depth + (before_operator ? 0 : 1);
    if (i >= room / 3 && !behind_operator && (best == 0 || cost <= best_cost)) {
      best = i;
      best_cost = cost;
    }
    behind_operator = before_operator;
  }
  if (best > 0) return best;
  if (const std::size_t factor = text.rfind('*', room - 1); factor != std::string_view::npos)
    return factor + 1;
  return room;
}

/// The same for sentences with short formulas: at the last blank that is beside no operator.
std::size_t sentence_end(std::string_view text, std::size_t room_in_columns) {
  if (columns(text) <= room_in_columns) return text.size();
  const std::size_t room = bytes_of(text, room_in_columns);
  std::size_t best = 0;
  bool behind_operator = false;
  for (std::size_t i = 0; i <= room; ++i) {
    if (text[i] != ' ') continue;
    const bool before_operator = starts_with_operator(text.substr(i + 1));
    if (!behind_operator && !before_operator) best = i;
    behind_operator = before_operator;
  }
  return best > room / 2 ? best : line_end(text, room_in_columns);
}

using LineEnd = std::size_t (*)(std::string_view text, std::size_t room_in_columns);

std::string broken(std::string_view text, std::string_view first, std::size_t width,
                   LineEnd end_of_line) {
  std::string lines;
  std::string prefix(first);
  const std::size_t used = columns(first);
  const std::size_t room = width > used + 10 ? width - used : 10;
  do {
    const std::size_t end = end_of_line(text, room);
    lines += prefix + std::string(text.substr(0, end)) + "\n";
    text.remove_prefix(end);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    prefix = blanks(used);
  } while (!text.empty());
  std::replace(lines.begin(), lines.end(), held_blank, ' ');
  return lines;
}

}  // namespace

std::string wrapped(std::string_view text, std::string_view first, std::size_t width) {
  return broken(text, first, width, line_end);
}

std::string wrapped_sentences(std::string_view text, std::string_view first, std::size_t width) {
  return broken(text, first, width, sentence_end);
}

}  // namespace magicmass::render
