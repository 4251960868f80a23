// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <memory>

#include "command/commands.hpp"
#include "command/nearest_name.hpp"
#include "command/records.hpp"
#include "command/refusal.hpp"
#include "magicmass/errors.hpp"
#include "render/derivation_pages.hpp"
#include "render/steps.hpp"

namespace magicmass::command {
namespace {

struct DeriveOptions {
  std::vector<std::string> chapters;
  bool summary = false;
  OutputOptions output;
};

std::string page(const std::vector<proof::Step>& steps, const DeriveOptions& options,
                 bool colourful) {
  if (options.summary) return render::derivation_summary(steps, colourful);
  if (options.output.format == "json") return render::derivation_json(steps);
  if (options.output.format == "markdown") return render::derivation_markdown(steps);
  return render::derivation_text(steps, colourful);
}

ExitCode derive(const DeriveOptions& options) {
  for (const std::string& chapter : options.chapters)
    require_name("chapter", chapter, derivation::chapter_names());
  if (options.summary && options.output.format != "text")
    throw InvalidInput("--summary is text alone; allowed with it: --format text");
  Destination output(options.output.path);
  const derivation::Derivation derivation = derivation::derive();
  std::vector<proof::Step> steps = render::steps_of(derivation);
  const auto is_unwanted = [&](const proof::Step& step) {
    return !options.chapters.empty() && step.verdict != "refused" &&
           std::find(options.chapters.begin(), options.chapters.end(), render::chapter_of(step)) ==
               options.chapters.end();
  };
  steps.erase(std::remove_if(steps.begin(), steps.end(), is_unwanted), steps.end());
  output.write(page(steps, options, output.is_colourful()));
  output.finish();
  return say_if_refused(derivation);
}

}  // namespace

void add_derive(Program& program) {
  const auto options = std::make_shared<DeriveOptions>();
  CLI::App& command = add_command(program, "derive",
                                  "The derivation, from the conservation laws, proved line by line",
                                  "magicmass derive power counting");
  command.add_option("CHAPTER", options->chapters, "chapters to print; all without one")
      ->type_name("");
  command.add_flag("--summary", options->summary, "the laws and the main theorems alone");
  add_output_options(command, options->output, {"text", "markdown", "json"});
  on_run(program, command, [options] { return derive(*options); });
}

}  // namespace magicmass::command
