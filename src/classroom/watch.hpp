// SPDX-License-Identifier: GPL-2.0-or-later
// Answers are judged whenever their files are saved.
#pragma once

#include <functional>
#include <string_view>

#include "learn/judge.hpp"

namespace classroom {

/// Says what it watches, then a block for each answer; after an empty piece all is to be seen.
/// Goes on until say() throws, or the program ends.
[[noreturn]] void watch(const std::vector<learn::Exercise>& all, const std::string& folder,
                        const learn::Run& run, const std::function<void(std::string_view)>& say);

}  // namespace classroom
