// SPDX-License-Identifier: GPL-2.0-or-later
// The command line as data, read from CLI11's own tree: what man pages, completions and tests are made of.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace magicmass::command {

enum class Takes { nothing, text, file, folder };

/// An option, or an argument without a name of its own.
struct OptionText {
  std::vector<std::string> names;    ///< "-o", "--output"; "SCENE" of an argument
  Takes takes = Takes::nothing;      ///< what follows it
  std::string value;                 ///< what its value is called: "FILE"
  std::vector<std::string> choices;  ///< values to offer; none where they are not a short list
  std::string words;
  bool is_required = false;
};

struct CommandText {
  std::string name;  ///< in full: "magicmass eval"
  std::string summary;
  std::vector<std::string> examples;
  std::vector<OptionText> arguments;
  std::vector<OptionText> options;
  std::string notes;  ///< lines below the options
  std::vector<CommandText> commands;
  bool is_hidden = false;

  /// "eval" of "magicmass eval".
  std::string last_word() const { return name.substr(name.rfind(' ') + 1); }
};

/// The command and all below it, in the order of its help.
CommandText command_tree(const CLI::App& app, const std::string& parents = "");

/// The command itself and all visible ones below it, each before those below it.
std::vector<const CommandText*> visible_commands(const CommandText& command);

}  // namespace magicmass::command
