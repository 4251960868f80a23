// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

namespace magicmass::command {

/// Throws InvalidInput, with the nearest of the names and all of them, unless `name` is one of them:
/// `no chapter is called "powr"; did you mean power? allowed: ...`.
void require_name(const std::string& kind, const std::string& name,
                  const std::vector<std::string>& names);

}  // namespace magicmass::command
