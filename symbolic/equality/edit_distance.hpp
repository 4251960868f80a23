// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace magicmass::equality {

// Letters to insert, delete or replace to make one word the other.
std::size_t edit_distance(const std::string& from, const std::string& to);

}  // namespace magicmass::equality
