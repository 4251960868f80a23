// SPDX-License-Identifier: GPL-2.0-or-later
// Another program, its input and output in memory.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace command {

struct Said {
  bool is_done;  ///< exit code 0
  std::string output;
  std::string errors;
};
/// What the program words[0] says; nothing where it is not installed.
std::optional<Said> said_by(std::vector<std::string> words, const std::string& input = "");

}  // namespace command
