// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "command/commands.hpp"
#include "command/destination.hpp"
#include "command/known_words.hpp"
#include "command/leftover.hpp"
#include "command/program.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace {

using namespace magicmass::command;

/// The command a message is about, with the program's name: "magicmass eval".
std::string full_name(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app.get_name() : app.get_name() + " " + full_name(*commands.front());
}

/// One line, whatever the message holds.
ExitCode say(std::string message, ExitCode code) {
  for (char& character : message)
    if (character == '\n') character = ' ';
  std::cerr << "magicmass: " + magicmass::shown_text(message, 4000) + "\n";
  return code;
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
                         add_figure, add_animate, add_reproduce, add_learn, add_doctor, add_manual})
    add(program);
  treat_values_alike(program.app);
  try {
    std::vector<std::string> words = with_expressions_marked(argc, argv);
    require_values(words);
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    program.app.parse(words);
  } catch (const CLI::CallForHelp&) {
    print(program.app.help());
    return ExitCode::done;
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + "\n");
    return ExitCode::done;
  } catch (const CLI::ParseError& error) {
    require_known_words(program.app);
    std::string message = error.what();
    while (message.ends_with('\n') || message.ends_with('.')) message.pop_back();
    return say(message + "; see " + full_name(program.app) + " --help", ExitCode::bad_input);
  }
  return program.action();
}

/// Where one was closed a file would get its number, and what is meant for the terminal: it gets a stream that takes
/// and gives nothing.
void open_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0)
      ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large for its limit is refused as on a full disk
  std::signal(SIGPIPE, SIG_IGN);  // a reader that has seen enough is no error: see ClosedPipe
  remove_leftovers_on_signals();
  ExitCode code = ExitCode::done;
  try {
    code = run(argc, argv);
  } catch (const ClosedPipe&) {
    code = ExitCode::done;
  } catch (const magicmass::InvalidInput& error) {
    code = say(error.what(), ExitCode::bad_input);
  } catch (const std::filesystem::filesystem_error& error) {
    code = say(words_of(error), ExitCode::bad_input);
  } catch (const std::bad_alloc&) {
    code = say("the answer does not fit into memory", ExitCode::undecided);
  } catch (
      const std::exception& error) {  // Undecided, and what CLN says of numbers too large for it
    code = say(error.what(), ExitCode::undecided);
  }
  return static_cast<int>(code);
}
