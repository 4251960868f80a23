// SPDX-License-Identifier: GPL-2.0-or-later
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "command/alpha_value.hpp"
#include "command/commands.hpp"
#include "command/scene_pages.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

struct SimulateOptions {
  std::string scene;
  SceneOptions run;
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
  SceneResult result;
  try {
    result = run_scene(scene, options.run);
  } catch (const InvalidInput& error) {
    throw InvalidInput(shown_text(options.scene, 200) + ": " + error.what());
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
  command.add_flag("--exact", options->run.exact,
                   "rational arithmetic; not at magic:k, deficient:k");
  command.add_option("--max-events", options->run.max_events, "stop after so many (1000000)")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1} << 40U).description(""));
  add_output_options(command, options->output);
  on_run(program, command, [options] { return simulate(*options); });
}

}  // namespace magicmass::command
