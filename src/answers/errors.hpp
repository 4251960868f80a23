// SPDX-License-Identifier: GPL-2.0-or-later
// What an answer throws instead; what() is one line, fit to be shown. Words of others in messages
// of ours.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "magicmass/numbers/errors.hpp"

namespace answers {

using magicmass::InvalidInput;  ///< exit code 2
using magicmass::Undecided;     ///< exit code 3

/// Printable ASCII as it is, other bytes as \xHH, so that no terminal obeys them; cut with "..."
/// after so many bytes; "(nothing)" where there are none.
std::string shown_text(std::string_view text, std::size_t longest = 60);

/// The texts with ", " between them.
std::string joined(const std::vector<std::string>& texts, std::string_view between = ", ");

}  // namespace answers
