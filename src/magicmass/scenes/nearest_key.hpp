// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace magicmass {

/// The one of `keys` that a misspelt key most likely means: the fewest letters to insert, delete, replace or swap with
/// their neighbours, at most one for each two letters of the key; none where no key is that near.
std::optional<std::string_view> nearest_key(std::string_view key,
                                            const std::vector<std::string_view>& keys);

}  // namespace magicmass
