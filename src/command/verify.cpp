// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>

#include "command/commands.hpp"
#include "command/program.hpp"
#include "command/records.hpp"
#include "command/refusal.hpp"
#include "render/steps.hpp"

namespace magicmass::command {
namespace {

ExitCode verify(const OutputOptions& options) {
  Destination output(options.path);
  const derivation::Derivation derivation = derivation::derive();
  const std::vector<proof::Step> steps = render::steps_of(derivation);
  const auto cell = [&](const char* verdict) {
    return digits_cell(std::to_string(render::count_verdict(steps, verdict)));
  };
  RecordWriter writer(output, options.format,
                      {"proved", "failed", "laws", "definitions", "hypotheses"}, true);
  writer.write(
      {cell("proved"), cell("refused"), cell("law"), cell("definition"), cell("hypothesis")});
  writer.finish();
  output.finish();
  return say_if_refused(derivation);
}

}  // namespace

void add_verify(Program& program) {
  const auto options = std::make_shared<OutputOptions>();
  CLI::App& command =
      add_command(program, "verify", "Prove every step again; exit code 1 if one is refused",
                  "magicmass verify --format json");
  add_output_options(command, *options);
  on_run(program, command, [options] { return verify(*options); });
}

}  // namespace magicmass::command
