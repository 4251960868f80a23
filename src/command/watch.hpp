// SPDX-License-Identifier: GPL-2.0-or-later
// Answers are judged whenever their files are saved.
#pragma once

#include <functional>
#include <string_view>

#include "learn/judge.hpp"

namespace command {

/// Says what it watches, then each verdict as `format` has it, text or json; an empty piece ends
/// what is to be seen at once. Goes on until say() throws, or the program ends.
[[noreturn]] void watch(const std::vector<learn::Exercise>& all, const std::string& folder,
                        const std::string& format, const learn::Run& run,
                        const std::function<void(std::string_view)>& say);

}  // namespace command
