// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace magicmass {

/// Letters to insert, delete, replace or swap with their neighbours to make one word the other (Damerau's distance).
std::size_t edit_distance(std::string_view from, std::string_view to);

/// The one of `keys` that a misspelt key most likely means: the least edit_distance, at most one for each two letters
/// of the key; none where no key is that near.
std::optional<std::string_view> nearest_key(std::string_view key,
                                            const std::vector<std::string_view>& keys);

}  // namespace magicmass
