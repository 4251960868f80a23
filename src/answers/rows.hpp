// SPDX-License-Identifier: GPL-2.0-or-later
// Many requests at once: rows of fields go through the array functions.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "answers/request.hpp"

namespace answers {

/// Requests that differ in some options: fields[row] has theirs, in the order of `columns`.
struct Rows {
  Request shared;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> fields = {};

  Request request(std::size_t row) const;
};

/// The same answers as of eval, count and terminal, bit for bit, where a mass ratio is a double and
/// the tier is fast or accurate; other rows have none here, as have those that are refused.
Block eval_block(const Rows& rows);
Block count_block(const Rows& rows);
Block terminal_block(const Rows& rows);

}  // namespace answers
