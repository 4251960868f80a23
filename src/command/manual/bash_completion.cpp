// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "command/manual/completions.hpp"

namespace magicmass::command {
namespace {

/// What to offer for a value: a line that fills COMPREPLY, or nothing.
std::string values(const OptionText& text) {
  if (!text.choices.empty()) return fmt::format("offered='{}'", fmt::join(text.choices, " "));
  if (text.takes == Takes::file) return "compopt -o default 2>/dev/null; return";
  if (text.takes == Takes::folder) return "compopt -o dirnames 2>/dev/null; return";
  return "return";
}

std::string after_option(const CommandText& command) {
  std::string cases;
  for (const OptionText& option : command.options) {
    if (option.takes == Takes::nothing) continue;
    std::string patterns;
    for (const std::string& name : option.names)
      patterns += fmt::format("{}'{} {}'", patterns.empty() ? "" : " | ", command.name, name);
    cases += fmt::format("    {}) {} ;;\n", patterns, values(option));
  }
  return cases;
}

std::string words_of(const CommandText& command) {
  std::string words, arguments;
  for (const CommandText& below : command.commands)
    if (!below.is_hidden) words += below.last_word() + " ";
  for (const OptionText& text : command.arguments)
    for (const std::string& choice : text.choices) words += choice + " ";
  for (const OptionText& option : command.options)
    for (const std::string& name : option.names) words += name + " ";
  for (const OptionText& text : command.arguments)
    if (text.takes == Takes::file || text.takes == Takes::folder)
      arguments = " compopt -o default 2>/dev/null";
  if (!words.empty()) words.pop_back();
  return fmt::format("    '{}') offered='{}'{} ;;\n", command.name, words,
                     arguments.empty() ? "" : ";" + arguments);
}

}  // namespace

std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char character : text)
    quoted += character == '\'' ? std::string("'\\''") : std::string(1, character);
  return quoted + "'";
}

std::string bash_completion(const CommandText& program) {
  std::string commands, after, words;
  for (const CommandText* command : visible_commands(program)) {
    if (command != &program) commands += (commands.empty() ? "'" : " | '") + command->name + "'";
    after += after_option(*command);
    words += words_of(*command);
  }
  return fmt::format(R"(# SPDX-License-Identifier: GPL-2.0-or-later
# bash completion for {0}, written by `{0} manual` from the command line itself.
_{0}() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD - 1]}}
  local command={0} offered='' i
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    case "$command ${{COMP_WORDS[i]}}" in
      {1}) command="$command ${{COMP_WORDS[i]}}" ;;
    esac
  done
  case "$command $previous" in
{2}    *) case $command in
{3}    esac ;;
  esac
  mapfile -t COMPREPLY < <(compgen -W "$offered" -- "$current")
}}
complete -F _{0} {0}
)",
                     program.name, commands, after, words);
}

}  // namespace magicmass::command
