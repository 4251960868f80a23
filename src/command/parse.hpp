// SPDX-License-Identifier: GPL-2.0-or-later
// From the words of the command line to a request.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "answers/request.hpp"
#include "command/command.hpp"

namespace command {

/// What all commands share.
struct Asked {
  const Command* command = nullptr;
  answers::Request request;
  std::string output;                ///< -o: a file's name, "" or "-" for stdout
  std::optional<std::string> input;  ///< --input: a file of CSV, "-" for stdin
  Limits limits;                     ///< --time-limit, --memory-limit
};

/// What was asked, or the text of --help or --version. Throws answers::InvalidInput for words that
/// ask for nothing.
std::variant<Asked, std::string> parse(const Program& program, std::vector<std::string> words);

}  // namespace command
