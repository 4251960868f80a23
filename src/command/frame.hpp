// From words of the command line to a request; the bound on time and memory around what answers it.
#pragma once

#include "command/command.hpp"

namespace command {

struct Asked {
  const Command* command = nullptr;
  answers::Request request;  ///< with what all commands share: input, output
  Limits limits;             ///< --time-limit, --memory-limit
};

/// What was asked, or the text of --help or --version. Throws answers::InvalidInput for all else.
std::variant<Asked, std::string> parse(const Program& program, std::vector<std::string> words);

/// Tells how many rows are done; 0: output begins, so that the terminal's progress line goes.
using Tell = std::function<void(std::uint64_t rows)>;

/// Runs the action in a child with these limits and returns its exit code. Where that was late, out
/// of memory or crashed, says so after `name`, with the rows done and what would do, and returns
/// ExitCode::undecided. After a second a terminal on stderr shows how long it has been. Ends by the
/// signal that ended the child, where that was the user's.
ExitCode run_bounded(const std::string& name, const Limits& limits,
                     const std::function<ExitCode(const Tell&)>& action);

/// One line on stderr, whatever the message holds.
ExitCode say(const std::string& message, ExitCode code);

}  // namespace command
