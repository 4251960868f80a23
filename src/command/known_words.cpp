// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/known_words.hpp"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command/nearest_name.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/nearest_key.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) names.push_back(command->get_name());
  return names;
}

[[noreturn]] void refuse_option(const std::string& name, const std::string& command,
                                const std::vector<std::string>& names) {
  const std::string nearest = nearest_name(name, names);
  const bool is_near = edit_distance(name.substr(0, 40), nearest) <= name.size() / 2;
  throw InvalidInput(command + " has no option " + shown_text(name, 100) +
                     (is_near ? "; did you mean " + nearest + "?" : ";") + " see " + command +
                     " --help");
}

}  // namespace

void require_known_words(const CLI::App& app) {
  const CLI::App* asked = &app;
  std::string command = app.get_name();
  while (!asked->get_subcommands().empty()) {
    asked = asked->get_subcommands().front();
    command += " " + asked->get_name();
  }
  const std::vector<std::string> commands = command_names(*asked);
  for (const std::string& word : app.remaining(true)) {
    if (word.size() > 1 && word.front() == '-' && word != "--")
      refuse_option(word.substr(0, word.find('=')), command, option_names(*asked));
    if (!commands.empty())
      require_name(asked == &app ? "command" : "command of " + command, word, commands);
  }
}

void require_values(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") return;
    if (word.starts_with("-o="))
      throw InvalidInput("-o= is no option; allowed: -o FILE and --output=FILE");
    if (word.starts_with("--") && word.find('=') == word.size() - 1)
      throw InvalidInput(shown_text(word, 100) + " has no value");
  }
}

}  // namespace magicmass::command
