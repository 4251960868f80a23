// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command/exit_code.hpp"

namespace magicmass::command {

/// The command line as it is being described, and what it turned out to ask for.
struct Program {
  CLI::App app;
  std::function<ExitCode()> action;  ///< set by parsing, run after it
};

/// A command with its one-line summary and a line to try, which its help begins with.
CLI::App& add_command(Program& program, const std::string& name, const std::string& summary,
                      const std::string& example);

/// Runs `action` when the command was asked for.
void on_run(Program& program, CLI::App& command, std::function<ExitCode()> action);

/// Values that a shell's completion offers; which are allowed the command says itself.
void offer(CLI::Option& option, const std::vector<std::string>& values);

/// What holds of options by the kind of their values, once all are described: no file and no folder is called "", and
/// a whole number is written in decimal digits, whatever zeros it begins with.
void treat_values_alike(CLI::App& app);

/// Names the program and makes its help begin with examples.
void describe(Program& program);

}  // namespace magicmass::command
