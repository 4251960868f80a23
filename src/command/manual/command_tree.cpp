// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/manual/command_tree.hpp"

#include <sstream>

#include <CLI/CLI.hpp>

namespace magicmass::command {
namespace {

/// "FORMAT:{text,json}" is a value's name and its choices, as CLI11 joins them.
void read_value(const CLI::Option& option, OptionText& text) {
  const std::string type = option.get_type_name();
  const std::size_t list = type.find(":{");
  text.value = type.substr(0, list);
  if (list == std::string::npos) return;
  std::istringstream choices(type.substr(list + 2, type.find('}') - list - 2));
  for (std::string choice; std::getline(choices, choice, ',');) text.choices.push_back(choice);
}

Takes kind_of(const OptionText& text) {
  const std::string& name = text.value.empty() ? text.names.front() : text.value;
  if (name.starts_with("FILE") || name == "SCENE") return Takes::file;
  return name == "DIR" || name == "FOLDER" ? Takes::folder : Takes::text;
}

OptionText option_text(const CLI::Option& option) {
  OptionText text;
  text.words = option.get_description();
  text.is_required = option.get_required();
  if (option.nonpositional()) {
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  } else {
    text.names.push_back(option.get_name(true));
  }
  if (option.get_items_expected_max() == 0) return text;
  read_value(option, text);
  text.takes = kind_of(text);
  return text;
}

}  // namespace

CommandText command_tree(const CLI::App& app, const std::string& parents) {
  CommandText command;
  command.name = parents + app.get_name();
  std::istringstream description(app.get_description());
  std::getline(description, command.summary);
  for (std::string line; std::getline(description, line);)
    command.examples.push_back(line.substr(line.find_first_not_of(' ')));
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty())
      (option->nonpositional() ? command.options : command.arguments)
          .push_back(option_text(*option));
  command.notes = app.get_footer();
  command.is_hidden = app.get_group().empty();
  for (const CLI::App* below : app.get_subcommands({}))
    command.commands.push_back(command_tree(*below, command.name + " "));
  return command;
}

std::vector<const CommandText*> visible_commands(const CommandText& command) {
  std::vector<const CommandText*> all{&command};
  for (const CommandText& below : command.commands) {
    if (below.is_hidden) continue;
    const auto further = visible_commands(below);
    all.insert(all.end(), further.begin(), further.end());
  }
  return all;
}

}  // namespace magicmass::command
