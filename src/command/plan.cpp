// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>

#include <fmt/format.h>

#include "command/commands.hpp"
#include "command/line_pages.hpp"
#include "command/model_option.hpp"
#include "command/program.hpp"
#include "command/records.hpp"
#include "magicmass/reference/rational.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

struct PlanOptions {
  std::string scene;
  reference::SceneOptions run;
  OutputOptions output;
};

ExitCode plan(const PlanOptions& options) {
  const reference::Plan chosen = reference::plan(read_scene(options.scene), options.run);
  Destination output(options.output.path);
  if (options.output.format == "json")
    output.write(plan_json(chosen) + "\n");
  else if (options.output.format == "csv")
    output.write("model,reason,events\n" +
                 csv_line({text_cell(chosen.model), text_cell(chosen.reason),
                           digits_cell(reference::to_text(chosen.events))}));
  else
    output.write(fmt::format("model   {}\n{}events  {}\n", chosen.model,
                             render::wrapped(chosen.reason, "reason  "),
                             reference::to_text(chosen.events)));
  output.finish();
  return ExitCode::done;
}

}  // namespace

void add_plan(Program& program) {
  const auto options = std::make_shared<PlanOptions>();
  CLI::App& command =
      add_command(program, "plan", "Which model a scene needs, why, and how many events",
                  "magicmass plan tutorials/scenes/wall.toml");
  command.add_option("SCENE", options->scene, "a scene file in TOML")->type_name("")->required();
  add_model_option(command, options->run);
  add_output_options(command, options->output);
  on_run(program, command, [options] { return plan(*options); });
}

}  // namespace magicmass::command
