// SPDX-License-Identifier: GPL-2.0-or-later
// The bound on time and memory, put once around whatever a command does.
#pragma once

#include <functional>
#include <string>

#include "command/command.hpp"

namespace command {

/// Tells the terminal's progress line that output begins.
using HideProgress = std::function<void()>;

/// Runs the action in a child with these limits and returns its exit code. Where that was late, out
/// of memory or crashed, says so after `name`, with what would do, and returns ExitCode::undecided.
/// After a second a terminal on stderr shows how long it has been. Ends by the signal that ended
/// the child, where that was the user's.
ExitCode run_bounded(const std::string& name, const Limits& limits,
                     const std::function<ExitCode(const HideProgress&)>& action);

/// One line on stderr, whatever the message holds.
ExitCode say(const std::string& message, ExitCode code);

}  // namespace command
