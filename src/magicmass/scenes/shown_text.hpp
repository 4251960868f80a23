// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace magicmass {

/// Untrusted text made fit for one line of an error message: all but printable ASCII escaped as \xNN,
/// cut after `longest` characters with "...", and "(nothing)" for the empty text.
std::string shown_text(std::string_view text, std::size_t longest = 60);

}  // namespace magicmass
