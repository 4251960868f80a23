// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "command/manual/completions.hpp"

namespace magicmass::command {
namespace {

/// Text inside a specification of _arguments or _describe, where : [ ] \ have meanings.
std::string within(const std::string& text) {
  std::string escaped;
  for (const char character : text) {
    if (std::string(":[]\\").find(character) != std::string::npos) escaped += '\\';
    escaped += character;
  }
  return escaped;
}

std::string action(const OptionText& text) {
  if (!text.choices.empty()) return fmt::format("({})", fmt::join(text.choices, " "));
  if (text.takes == Takes::file) return "_files";
  return text.takes == Takes::folder ? "_files -/" : "";
}

std::string specification(const OptionText& option, const std::string& name) {
  std::string text = name + "[" + within(option.words) + "]";
  if (option.takes != Takes::nothing)
    text += ":" + within(option.value.empty() ? "value" : option.value) + ":" + action(option);
  return " \\\n    " + shell_quoted(text);
}

std::string function_name(const CommandText& command) {
  std::string name = "_" + command.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string functions(const CommandText& command) {
  std::string text = function_name(command) + "() {\n";
  const bool has_commands = !command.commands.empty();
  std::string options;
  for (const OptionText& option : command.options)
    for (const std::string& name : option.names) options += specification(option, name);
  if (!has_commands) {
    for (std::size_t i = 0; i < command.arguments.size(); ++i) {
      const OptionText& argument = command.arguments[i];
      const std::string place = i + 1 == command.arguments.size() ? "*" : std::to_string(i + 1);
      options += " \\\n    " + shell_quoted(place + ":" + within(argument.names.front()) + ":" +
                                            action(argument));
    }
    return text + "  _arguments" + options + "\n}\n";
  }
  std::string names, calls, below_functions;
  for (const CommandText& below : command.commands) {
    if (below.is_hidden) continue;
    names += "\n        " + shell_quoted(within(below.last_word()) + ":" + within(below.summary));
    calls += fmt::format("        {}) {} ;;\n", below.last_word(), function_name(below));
    below_functions += functions(below);
  }
  return text + "  local state line\n  local -a commands\n  _arguments -C" + options +
         " \\\n    '1: :->command' '*:: :->rest'\n  case $state in\n    command)\n      "
         "commands=(" +
         names + ")\n      _describe command commands ;;\n    rest)\n      case $line[1] in\n" +
         calls + "      esac ;;\n  esac\n}\n" + below_functions;
}

}  // namespace

std::string zsh_completion(const CommandText& program) {
  return fmt::format(
      "#compdef {0}\n# SPDX-License-Identifier: GPL-2.0-or-later\n"
      "# zsh completion for {0}, written by `{0} manual` from the command line itself.\n{1}"
      "if [[ $funcstack[1] == _{0} ]]; then _{0} \"$@\"; else compdef _{0} {0}; fi\n",
      program.name, functions(program));
}

}  // namespace magicmass::command
