// SPDX-License-Identifier: GPL-2.0-or-later
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "command/alpha_value.hpp"
#include "command/commands.hpp"
#include "command/line_output.hpp"
#include "command/model_option.hpp"
#include "command/program.hpp"
#include "command/scene_pages.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/line_plan.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

struct SimulateOptions {
  std::string scene;
  reference::SceneOptions run;
  OutputOptions output;
};

/// A double is not the number it stands for: next to a threshold the loop may see one collision more or less.
void say_where_counts_differ(const SceneResult& result) {
  if (!result.stepped || result.status != "complete") return;
  if (result.stepped->N_A == result.counts.N_A && result.stepped->N_B == result.counts.N_B) return;
  std::cerr << "magicmass: note: the event loop in doubles made another number of collisions than "
               "the exact "
               "count: alpha is at a threshold\n";
}

ExitCode simulate(const SimulateOptions& options) {
  const Scene scene = read_scene(options.scene);
  const reference::ExactLine line = reference::exact_line(scene);
  if (!reference::is_papers_scene(scene, options.run) || options.output.format == "jsonl") {
    write_line_run(scene, line, options.run, options.output);
    return ExitCode::done;
  }
  SceneResult result;
  const bool is_planned =
      options.run.scalars == reference::Scalars::planned && options.run.model.empty();
  try {
    result = run_scene(scene, options.run);
  } catch (const Undecided&) {  // beyond doubles: the general theorems go further
    if (!is_planned) throw;
    write_line_run(scene, line, options.run, options.output);
    return ExitCode::done;
  } catch (const InvalidInput& error) {
    const std::string what = error.what();
    throw InvalidInput(what.starts_with(options.scene + ":")
                           ? what
                           : shown_text(options.scene, 200) + ": " + what);
  }
  Destination output(options.output.path);
  output.write(scene_page(scene, result, options.output.format));
  output.finish();
  say_where_counts_differ(result);
  return ExitCode::done;
}

}  // namespace

void add_simulate(Program& program) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App& command =
      add_command(program, "simulate", "Run a scene: what collides when, and what comes out",
                  "magicmass simulate tutorials/scenes/trajectory_a.toml");
  command.add_option("SCENE", options->scene, "a scene file in TOML")->type_name("")->required();
  command.add_flag_callback(
      "--exact", [options] { options->run.scalars = reference::Scalars::exact; },
      "short for --scalar exact");
  add_model_option(command, options->run);
  add_output_options(command, options->output, {"text", "json", "csv", "jsonl"});
  on_run(program, command, [options] { return simulate(*options); });
}

}  // namespace magicmass::command
