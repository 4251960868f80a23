// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/nearest_name.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "magicmass/errors.hpp"
#include "magicmass/scenes/nearest_key.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
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
