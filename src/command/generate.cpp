// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/generate.hpp"

#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "command/commands.hpp"
#include "command/generated_tree.hpp"
#include "command/records.hpp"
#include "command/refusal.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

struct GenerateOptions {
  std::string folder = source_generated_folder().string();
  bool check = false;
  OutputOptions output;
};

std::string text_of(const std::string& status, std::size_t files, const std::string& folder,
                    const TreeDifference& difference) {
  std::string text;
  for (const std::string& path : difference.missing) text += "missing    " + path + "\n";
  for (const std::string& path : difference.different) text += "different  " + path + "\n";
  for (const std::string& path : difference.extra) text += "extra      " + path + "\n";
  return text + fmt::format("{}: {} files in {}\n", status, files, shown_text(folder, 200));
}

std::string json_of(const std::string& status, std::size_t files,
                    const TreeDifference& difference) {
  return fmt::format(
      "{{\"status\": {}, \"files\": {}, \"missing\": {}, \"different\": {}, \"extra\": {}}}\n",
      json_string(status), files, json_array(difference.missing), json_array(difference.different),
      json_array(difference.extra));
}

ExitCode generate(const GenerateOptions& options) {
  const derivation::Derivation derivation = derivation::derive();
  if (derivation.refused) return say_if_refused(derivation);
  const std::vector<codegen::GeneratedFile> files = codegen::generate(derivation.theorems);
  Destination output(options.output.path);
  if (!options.check) write_tree(options.folder, files);
  const TreeDifference difference = compare_tree(options.folder, files);
  const std::string status = difference.is_stale() ? "stale"
                             : options.check       ? "up to date"
                                                   : "written";
  output.write(options.output.format == "json"
                   ? json_of(status, files.size(), difference)
                   : text_of(status, files.size(), options.folder, difference));
  output.finish();
  if (!difference.is_stale()) return ExitCode::done;
  std::cerr << (options.check ? "magicmass: generated code is stale; run: magicmass generate\n"
                              : "magicmass: files are there that are not generated; remove them\n");
  return ExitCode::check_failed;
}

}  // namespace

void add_generate(Program& program) {
  const auto options = std::make_shared<GenerateOptions>();
  CLI::App& command =
      add_command(program, "generate", "Write the C++ of generated/ from the proved theorems",
                  "magicmass generate --check");
  command.add_option("--out", options->folder, "folder instead of the sources' generated/")
      ->type_name("DIR")
      ->check([](const std::string& path) {
        return std::string(path.empty() ? "no folder name" : "");
      });
  command.add_flag("--check", options->check, "compare instead of writing; 1 if stale");
  add_output_options(command, options->output, {"text", "json"});
  on_run(program, command, [options] { return generate(*options); });
}

}  // namespace magicmass::command
