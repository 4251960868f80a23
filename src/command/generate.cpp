// SPDX-License-Identifier: GPL-2.0-or-later
#include "codegen/generate.hpp"

#include <iostream>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "command/commands.hpp"
#include "command/generated_tree.hpp"
#include "command/program.hpp"
#include "command/records.hpp"
#include "command/refusal.hpp"
#include "command/specialised_header.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

struct GenerateOptions {
  std::string folder = source_generated_folder().string();
  bool check = false;
  std::optional<std::string> quantities;
  std::optional<std::string> scene;
  OutputOptions output;
  CLI::Option* folder_option = nullptr;
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

/// One header: to a file, to its place below a folder, or to stdout.
ExitCode generate_one(const GenerateOptions& options) {
  const SpecialisedHeader header = options.quantities ? header_of_quantities(*options.quantities)
                                                      : header_of_scene(*options.scene);
  const derivation::Derivation derivation = derivation::derive();
  if (derivation.refused) return say_if_refused(derivation);
  const codegen::GeneratedFile file = header.file(derivation.theorems);
  if (options.folder_option->count() > 0) {
    write_tree(options.folder, {file});
    return ExitCode::done;
  }
  Destination output(options.output.path);
  output.write(file.content);
  output.finish();
  return ExitCode::done;
}

/// Options that say different things about what is written, or where.
void require_one_purpose(const GenerateOptions& options) {
  if (!options.quantities && !options.scene) return;
  const auto refuse = [](const std::string& what) {
    throw InvalidInput(what +
                       "; allowed: one of --quantity and --scene, with -o FILE or --out DIR");
  };
  if (options.quantities && options.scene) refuse("--quantity and --scene ask for two headers");
  if (options.check)
    refuse("--check compares all of generated/ and takes no --quantity or --scene");
  if (options.output.format != "text") refuse("a header has no --format");
  if (options.folder_option->count() > 0 && !options.output.path.empty())
    refuse("-o and --out are two places for one header");
}

ExitCode generate(const GenerateOptions& options) {
  require_one_purpose(options);
  if (options.quantities || options.scene) return generate_one(options);
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
  CLI::App& command = add_command(
      program, "generate", "Write the C++ of generated/ from the proved theorems",
      "magicmass generate --check\n  magicmass generate --quantity a_t,rho -o a_t_rho.hpp\n  "
      "magicmass generate --scene tutorials/scenes/trajectory_a.toml -o scene.hpp");
  options->folder_option =
      command.add_option("--out", options->folder, "folder instead of the sources' generated/");
  options->folder_option->type_name("DIR");
  command.add_flag("--check", options->check, "compare instead of writing; 1 if stale");
  command
      .add_option("--quantity", options->quantities, "one header with just these, such as a_t,rho")
      ->type_name("NAMES");
  command.add_option("--scene", options->scene, "one header with just what a scene's outputs need")
      ->type_name("FILE");
  add_output_options(command, options->output, {"text", "json"});
  on_run(program, command, [options] { return generate(*options); });
}

}  // namespace magicmass::command
