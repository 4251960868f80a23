// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/nearest_name.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

/// Letters to insert, delete or replace to make one word the other.
std::size_t edit_distance(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& names) {
  const std::string start = name.substr(0, 40);  // longer is near to nothing
  return *std::min_element(names.begin(), names.end(), [&](const auto& x, const auto& y) {
    return edit_distance(start, x) < edit_distance(start, y);
  });
}

void require_name(const std::string& kind, const std::string& name,
                  const std::vector<std::string>& names) {
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw InvalidInput(fmt::format("no {} is called \"{}\"; did you mean {}? allowed: {}", kind,
                                 shown_text(name), nearest_name(name, names),
                                 fmt::join(names, ", ")));
}

}  // namespace magicmass::command
