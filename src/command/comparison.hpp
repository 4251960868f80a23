// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers of the paper beside ours, and whether they agree.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "answers/request.hpp"

namespace command {

struct Comparison {
  std::string label;     ///< of the equation, table or figure in the paper
  std::string number;    ///< what it is
  std::string printed;   ///< there
  std::string question;  ///< that we answer
  std::string column;    ///< of the answer
  std::string reason;    ///< why it differs, in words
  std::string ours;      ///< all digits that are worth something
  bool agrees = false;   ///< decimals to the digits printed; all else exactly
  bool is_fine = true;   ///< agrees, or differs for a reason that holds
};

/// The rows of paper_numbers.csv, each with the answer to its question. Throws std::runtime_error,
/// naming the row, for one that has no meaning.
std::vector<Comparison> comparisons(std::string_view paper_numbers);

/// For text and markdown a page with a table for each label. The check has failed where one is not
/// fine.
answers::Answer page_of(const std::vector<Comparison>& all, const std::string& format);

}  // namespace command
