// SPDX-License-Identifier: GPL-2.0-or-later
#include <sstream>

#include <fmt/format.h>

#include "command/manual/completions.hpp"

namespace magicmass::command {
namespace {

/// When a line is one of this command: its words are there, and none of a command below it.
std::string condition(const CommandText& command) {
  std::string tests;
  std::istringstream words(command.name.substr(command.name.find(' ') + 1));
  if (command.name.find(' ') != std::string::npos)
    for (std::string word; words >> word;)
      tests += (tests.empty() ? "" : "; and ") + ("__fish_seen_subcommand_from " + word);
  std::string below;
  for (const CommandText& one : command.commands)
    if (!one.is_hidden) below += " " + one.last_word();
  if (!below.empty())
    tests += (tests.empty() ? "" : "; and ") + ("not __fish_seen_subcommand_from" + below);
  return shell_quoted(tests);
}

std::string value(const OptionText& text) {
  if (!text.choices.empty())
    return fmt::format(" -x -a {}", shell_quoted(fmt::format("{}", fmt::join(text.choices, " "))));
  switch (text.takes) {
    case Takes::nothing:
      return "";
    case Takes::text:
      return " -x";
    case Takes::file:
      return " -r -F";
    case Takes::folder:
      return " -x -a '(__fish_complete_directories)'";
  }
  return "";
}

std::string fish_names(const OptionText& option) {
  std::string text;
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  return text;
}

std::string lines_of(const CommandText& command, const std::string& program) {
  const std::string start = "complete -c " + program + " -n " + condition(command);
  std::string lines;
  for (const CommandText& below : command.commands)
    if (!below.is_hidden)
      lines += start + " -f -a " + below.last_word() + " -d " + shell_quoted(below.summary) + "\n";
  for (const OptionText& argument : command.arguments) {
    if (!argument.choices.empty())
      lines += start + " -f" + value(argument).substr(3) + "\n";
    else if (argument.takes == Takes::file || argument.takes == Takes::folder)
      lines += start + " -F\n";
  }
  for (const OptionText& option : command.options)
    lines +=
        start + fish_names(option) + value(option) + " -d " + shell_quoted(option.words) + "\n";
  return lines;
}

}  // namespace

std::string fish_completion(const CommandText& program) {
  std::string script = fmt::format(
      "# SPDX-License-Identifier: GPL-2.0-or-later\n"
      "# fish completion for {0}, written by `{0} manual` from the command line itself.\n"
      "complete -c {0} -f\n",
      program.name);
  for (const CommandText* command : visible_commands(program))
    script += lines_of(*command, program.name);
  return script;
}

}  // namespace magicmass::command
