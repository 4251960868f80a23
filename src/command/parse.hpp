// SPDX-License-Identifier: GPL-2.0-or-later
// From the words of the command line to a request.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "answers/request.hpp"
#include "command/command.hpp"

namespace command {

struct Asked {
  const Command* command = nullptr;
  answers::Request request;  ///< with what all commands share: input, output
  Limits limits;             ///< --time-limit, --memory-limit
};

/// What was asked, or the text of --help or --version. Throws answers::InvalidInput for words that
/// ask for nothing.
std::variant<Asked, std::string> parse(const Program& program, std::vector<std::string> words);

}  // namespace command
