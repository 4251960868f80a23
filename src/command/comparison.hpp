// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of the paper beside ours, and whether they agree.
#pragma once

#include <string>
#include <string_view>

#include "answers/request.hpp"

namespace command {

/// The rows of paper_numbers.csv, each with our answer to its question, the verdict (agrees:
/// decimals to the digits printed, all else exactly; explained: for a reason that holds; differs)
/// and what is said of it. Throws std::runtime_error, naming the row, for one that has no meaning.
answers::Table comparisons(std::string_view paper_numbers);

/// For text and markdown a page with a table for each label. The check has failed where one
/// differs.
answers::Answer page_of(const answers::Table& comparisons, const std::string& format);

}  // namespace command
