// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "command/commands.hpp"
#include "command/destination.hpp"
#include "command/nearest_name.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace {

using namespace magicmass::command;

/// The command a message is about, with the program's name: "magicmass eval".
std::string full_name(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app.get_name() : app.get_name() + " " + commands.front()->get_name();
}

/// One line, whatever the message holds.
ExitCode say(std::string message, ExitCode code) {
  for (char& character : message)
    if (character == '\n') character = ' ';
  std::cerr << "magicmass: " + magicmass::shown_text(message, 4000) + "\n";
  return code;
}

/// CLI11 says of a misspelt command only that one is required.
void require_known_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || *argv[1] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  require_name("command", argv[1], names);
}

void print(const std::string& text) {
  Destination output("");
  output.write(text);
  output.finish();
}

ExitCode run(int argc, char** argv) {
  Program program;
  describe(program);
  for (const auto add : {add_derive, add_verify, add_equal, add_generate, add_eval, add_count,
                         add_terminal, add_ratios, add_simulate, add_plan, add_report, add_demo,
                         add_figure, add_animate, add_reproduce})
    add(program);
  require_known_command(program.app, argc, argv);
  try {
    std::vector<std::string> words = with_expressions_marked(argc, argv);
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    program.app.parse(words);
  } catch (const CLI::CallForHelp&) {
    print(program.app.help());
    return ExitCode::done;
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + "\n");
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    std::string message = error.what();
    while (message.ends_with('\n') || message.ends_with('.')) message.pop_back();
    return say(message + "; see " + full_name(program.app) + " --help", ExitCode::bad_input);
  }
  return program.action();
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has seen enough is no error: see ClosedPipe
  ExitCode code = ExitCode::done;
  try {
    code = run(argc, argv);
  } catch (const ClosedPipe&) {
    code = ExitCode::done;
  } catch (const magicmass::InvalidInput& error) {
    code = say(error.what(), ExitCode::bad_input);
  } catch (const std::bad_alloc&) {
    code = say("the answer does not fit into memory", ExitCode::undecided);
  } catch (
      const std::exception& error) {  // Undecided, and what CLN says of numbers too large for it
    code = say(error.what(), ExitCode::undecided);
  }
  return static_cast<int>(code);
}
