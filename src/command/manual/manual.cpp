// SPDX-License-Identifier: GPL-2.0-or-later
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "command/commands.hpp"
#include "command/manual/completions.hpp"
#include "command/manual/manual_page.hpp"
#include "command/program.hpp"
#include "command/records.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

struct ManualOptions {
  std::string pages;
  std::string completions;
  OutputOptions output;
};

void write_file(const std::filesystem::path& path, const std::string& content) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  if (error)
    throw InvalidInput("cannot write " + shown_text(path.string(), 200) + ": " + error.message());
  Destination output(path.string());
  output.write(content);
  output.finish();
}

std::string json(const OptionText& option) {
  return json_object({"names", "value", "choices", "words", "required"},
                     {{json_array(option.names)},
                      option.value.empty() ? missing_cell() : text_cell(option.value),
                      {json_array(option.choices)},
                      text_cell(option.words),
                      {option.is_required ? "true" : "false"}});
}

std::string json(const std::vector<OptionText>& options) {
  std::string array;
  for (const OptionText& option : options) array += (array.empty() ? "" : ", ") + json(option);
  return "[" + array + "]";
}

std::string json(const CommandText& command) {
  std::string below;
  for (const CommandText& one : command.commands) below += (below.empty() ? "" : ",\n") + json(one);
  return json_object(
      {"name", "summary", "examples", "arguments", "options", "notes", "hidden", "commands"},
      {text_cell(command.name),
       text_cell(command.summary),
       {json_array(command.examples)},
       {json(command.arguments)},
       {json(command.options)},
       text_cell(command.notes),
       {command.is_hidden ? "true" : "false"},
       {"[" + below + "]"}});
}

ExitCode manual(const CLI::App& app, const ManualOptions& options) {
  const CommandText program = command_tree(app);
  if (options.pages.empty() && options.completions.empty()) {
    Destination output(options.output.path);
    if (options.output.format == "json") output.write(json(program) + "\n");
    if (options.output.format == "text")
      for (const CommandText* command : visible_commands(program))
        output.write(fmt::format("{:<26}{}\n", command->name, command->summary));
    output.finish();
    return ExitCode::done;
  }
  if (!options.pages.empty())
    for (const CommandText* command : visible_commands(program))
      write_file(std::filesystem::path(options.pages) / manual_page_name(*command),
                 manual_page(*command, "magicmass " MAGICMASS_VERSION));
  if (!options.completions.empty()) {
    const std::filesystem::path folder = options.completions;
    write_file(folder / "magicmass", bash_completion(program));  // names by which shells find them
    write_file(folder / "_magicmass", zsh_completion(program));
    write_file(folder / "magicmass.fish", fish_completion(program));
  }
  return ExitCode::done;
}

}  // namespace

void add_manual(Program& program) {
  const auto options = std::make_shared<ManualOptions>();
  CLI::App& command =
      add_command(program, "manual", "All commands: listed, as man pages, or for a shell",
                  "magicmass manual --man build/man1 --completions build/completions");
  command.add_option("--man", options->pages, "write a man page for each command into DIR")
      ->type_name("DIR");
  command
      .add_option("--completions", options->completions, "write for bash, zsh and fish into DIR")
      ->type_name("DIR");
  add_output_options(command, options->output, {"text", "json"});
  command.group("");  // the build runs it
  on_run(program, command, [options, &program] { return manual(program.app, *options); });
}

}  // namespace magicmass::command
