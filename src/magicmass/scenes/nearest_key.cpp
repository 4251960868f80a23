// SPDX-License-Identifier: MIT
#include "magicmass/scenes/nearest_key.hpp"

#include <algorithm>

namespace magicmass {

std::size_t edit_distance(std::string_view from, std::string_view to) {
  // words are short, so the whole table is kept
  std::vector<std::vector<std::size_t>> table(from.size() + 1,
                                              std::vector<std::size_t>(to.size() + 1));
  for (std::size_t i = 0; i <= from.size(); ++i)
    for (std::size_t j = 0; j <= to.size(); ++j) {
      if (i == 0 || j == 0) {
        table[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = table[i - 1][j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      table[i][j] = std::min({table[i - 1][j] + 1, table[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
        table[i][j] = std::min(table[i][j], table[i - 2][j - 2] + 1);
    }
  return table.back().back();
}

std::optional<std::string_view> nearest_key(std::string_view key,
                                            const std::vector<std::string_view>& keys) {
  constexpr std::size_t longest = 40;  // longer is near to nothing
  std::optional<std::string_view> nearest;
  if (key.size() > longest) return nearest;
  std::size_t least = key.size() / 2 + 1;
  for (const std::string_view other : keys) {
    const std::size_t changes = edit_distance(key, other);
    if (changes >= least) continue;
    least = changes;
    nearest = other;
  }
  return nearest;
}

}  // namespace magicmass
