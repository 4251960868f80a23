// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>

#include <fmt/format.h>

#include "command/commands.hpp"
#include "command/line_pages.hpp"
#include "command/scene_run.hpp"
#include "magicmass/reference/rational.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

struct PlanOptions {
  std::string scene;
  SceneOptions run;
  OutputOptions output;
};

ExitCode plan(const PlanOptions& options) {
  const Scene scene = read_scene(options.scene);
  const reference::ExactLine line = reference::exact_line(scene);
  const Plan chosen = is_papers_scene(scene, options.run)
                          ? plan_papers_scene(scene, options.run)
                          : plan_line(scene, line, options.run).plan;
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

void add_model_option(CLI::App& command, SceneOptions& options) {
  command.add_option("--model", options.model, "the model to use (plan tells which)")
      ->type_name("MODEL");
  command
      .add_option_function<std::string>(
          "--scalar",
          [&options](const std::string& name) {
            options.scalars = name == "double"        ? Scalars::doubles
                              : name == "long-double" ? Scalars::long_doubles
                                                      : Scalars::exact;
          },
          "step events in double, long-double or exact")
      ->type_name("NAME")
      ->check(CLI::IsMember({"double", "long-double", "exact"}));
  command.add_option("--max-events", options.max_events, "stop after so many (1000000)")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 53U).description(""));
}

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
