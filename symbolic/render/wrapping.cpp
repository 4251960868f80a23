// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/wrapping.hpp"

#include <algorithm>
#include <vector>

namespace magicmass::render {
namespace {

std::string blanks(std::size_t count) { return std::string().append(count, ' '); }

/// Where to end a line that starts at text[0] and has room for `room` columns: at the blank that is within the fewest
/// brackets, the last of these, before an operator rather than behind it; else after a factor.
std::size_t line_end(std::string_view text, std::size_t room) {
  if (text.size() <= room) return text.size();
  std::size_t best = 0;
  int best_depth = 0;
  int depth = 0;
  for (std::size_t i = 0; i <= room; ++i) {
    if (text[i] == '(' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == ']') --depth;
    const bool behind_operator =
        i >= 2 && text[i - 2] == ' ' &&
        std::string_view("+-=").find(text[i - 1]) != std::string_view::npos;
    if (text[i] != ' ' || i < room / 3 || behind_operator) continue;
    if (best == 0 || depth <= best_depth) {
      best = i;
      best_depth = depth;
    }
  }
  if (best > 0) return best;
  if (const std::size_t factor = text.rfind('*', room - 1); factor != std::string_view::npos)
    return factor + 1;
  return room;
}

bool is_matrix(const std::string& text) { return text.starts_with("[["); }

/// "[[a, b], [c, d]]" as "[[a, b]," and "[c, d]]".
std::vector<std::string> matrix_rows(const std::string& text) {
  std::vector<std::string> rows;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = text.find("], [", begin);
    if (end == std::string::npos) break;
    rows.push_back(text.substr(begin, end + 2 - begin));
    begin = end + 3;
  }
  rows.push_back(text.substr(begin));
  return rows;
}

std::string wrapped_side(const std::string& side, const std::string& first) {
  if (!is_matrix(side)) return wrapped(side, first);
  std::string text;
  std::string prefix = first;
  for (const std::string& row : matrix_rows(side)) {
    text += wrapped(row, prefix);
    prefix = blanks(first.size() + 1);  // below the inner bracket of the first row
  }
  return text;
}

}  // namespace

std::string wrapped(std::string_view text, std::string_view first, std::size_t width) {
  std::string lines;
  std::string prefix(first);
  const std::size_t room = width > prefix.size() + 10 ? width - prefix.size() : 10;
  do {
    const std::size_t end = line_end(text, room);
    lines += prefix + std::string(text.substr(0, end)) + "\n";
    text.remove_prefix(end);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    prefix = blanks(first.size());
  } while (!text.empty());
  return lines;
}

std::string wrapped_equation(const std::string& from, const std::string& relation,
                             const std::string& to, std::size_t indent) {
  const std::string whole = from + " " + relation + " " + to;
  const bool fits = indent + whole.size() <= page_width;
  if (fits && !is_matrix(to)) return blanks(indent) + whole + "\n";
  const std::string head = from + " " + relation + " ";
  if (from.size() <= 20 && !is_matrix(from)) return wrapped_side(to, blanks(indent) + head);
  return wrapped_side(from, blanks(indent)) + wrapped_side(to, blanks(indent + 2) + relation + " ");
}

}  // namespace magicmass::render
