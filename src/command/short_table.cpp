// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/short_table.hpp"

#include <cstdlib>

#include <fmt/format.h>

#include "magicmass/reference/decimal.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::command {
namespace {

std::string short_number(const std::string& text) {
  if (text.size() <= 10) return text;
  if (text.find('/') != std::string::npos)
    return reference::to_decimal(reference::parse_rational(text), 5);
  return fmt::format("{:.5g}", std::strtod(text.c_str(), nullptr));
}

/// Beside a blank; what is wider pushes the rest of its line to the right.
int width(const std::string& column) {
  if (column == "body" || column == "left" || column == "right") return 5;
  return column == "n" || column == "number" ? 6 : 12;
}

}  // namespace

std::string short_head(const std::vector<std::string>& columns) {
  std::string text;
  for (const std::string& column : columns) text += fmt::format(" {:>{}}", column, width(column));
  return text + "\n";
}

std::string short_row(const std::vector<std::string>& columns, const std::vector<Cell>& row) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i)
    text += fmt::format(" {:>{}}", short_number(row[i].text), width(columns[i]));
  return text + "\n";
}

}  // namespace magicmass::command
