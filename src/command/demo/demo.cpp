// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "codegen/generate.hpp"
#include "command/commands.hpp"
#include "command/demo/demo_report.hpp"
#include "command/generated_tree.hpp"
#include "command/program.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"
#include "render/derivation_pages.hpp"
#include "render/steps.hpp"

namespace magicmass::command {

void show_derivation(DemoReport& report) {
  report.heading("From the conservation laws to theorems");
  const derivation::Derivation derivation = derivation::derive();
  const std::vector<proof::Step> steps = render::steps_of(derivation);
  report.print(
      render::derivation_summary(steps, {.unicode = false, .colourful = report.is_colourful()}));
  const std::size_t proved = render::count_verdict(steps, "proved");
  report.check(
      fmt::format("{} steps proved, {} refused", proved, render::count_verdict(steps, "refused")),
      !derivation.refused);

  report.heading("From theorems to C++");
  if (derivation.refused) {
    report.check(fmt::format("nothing is generated: {}", derivation.refused->what()), false);
    return;
  }
  const std::vector<codegen::GeneratedFile> files = codegen::generate(derivation.theorems);
  const TreeDifference difference = compare_tree(source_generated_folder(), files);
  for (const auto& [name, paths] :
       {std::pair("missing", difference.missing), std::pair("different", difference.different),
        std::pair("extra", difference.extra)})
    for (const std::string& path : paths) report.print(fmt::format("{}: {}\n", name, path));
  report.check(fmt::format("{} files generated again: the same bytes as generated/", files.size()),
               !difference.is_stale());
}

namespace {

ExitCode demo(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InvalidInput("cannot write " + shown_text(folder.string(), 200) + ": " + error.message());
  Destination output("");
  DemoReport report(output);
  show_derivation(report);
  show_scenes(report, folder);
  show_evaluators(report);
  show_ratios(report);
  draw_scenes(report, folder);
  report.print("\n");
  report.check("demo: every comparison", !report.has_failed());
  output.finish();
  return report.has_failed() ? ExitCode::check_failed : ExitCode::done;
}

}  // namespace

void add_demo(Program& program) {
  const auto folder = std::make_shared<std::string>("build/demo");
  CLI::App& command = add_command(program, "demo", "The whole chain on the paper's own numbers",
                                  "magicmass demo --out build/demo");
  command.add_option("--out", *folder, "folder for the figure and its data")->type_name("DIR");
  command.group("");  // `cmake --workflow --preset demo` runs it
  on_run(program, command, [folder] { return demo(*folder); });
}

}  // namespace magicmass::command
