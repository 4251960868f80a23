// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace magicmass::command {

/// The name that takes the fewest changes of letters to get to; `names` must not be empty.
std::string nearest_name(const std::string& name, const std::vector<std::string>& names);

/// Throws InvalidInput, with the nearest of the names and all of them, unless `name` is one of them:
/// `no chapter is called "powr"; did you mean power? allowed: ...`.
void require_name(const std::string& kind, const std::string& name,
                  const std::vector<std::string>& names);

}  // namespace magicmass::command
