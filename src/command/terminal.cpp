// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>

#include "command/alpha_value.hpp"
#include "command/commands.hpp"
#include "command/questions.hpp"
#include "command/velocity_tiers.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::command {
namespace {

struct TerminalOptions {
  QuestionOptions asked;
  AccuracyOptions accuracy;
  double restitution = 1.0;
  OutputOptions output;
};

}  // namespace

void add_terminal(Program& program) {
  const auto options = std::make_shared<TerminalOptions>();
  CLI::App& command =
      add_command(program, "terminal", "Velocities after the last collision, and the energy B got",
                  "magicmass terminal --alpha 0.12");
  add_question_options(command, options->asked);
  command.add_option("--restitution", options->restitution, "1 (elastic) is the only one so far")
      ->type_name("E");
  add_accuracy_options(command, options->accuracy);
  add_output_options(command, options->output);
  on_run(program, command, [options] {
    if (options->restitution != 1.0)
      throw InvalidInput("restitution other than 1 is not derived yet; allowed: --restitution 1");
    const Accuracy wanted = accuracy(options->accuracy);
    answer_all(options->asked, false, options->output,
               {"alpha", "N_A", "N_B", "a_t", "b_t", "c_t", "rho"}, [&](const Question& question) {
                 const MassRatio alpha = parse_mass_ratio(question.alpha);
                 const reference::LargeCounts counts = exact_counts(alpha);
                 const TerminalCells v = terminal_velocities(alpha, counts, wanted);
                 return std::vector<Cell>{alpha_cell(alpha),
                                          digits_cell(reference::to_text(counts.N_A)),
                                          digits_cell(reference::to_text(counts.N_B)),
                                          v.a_t,
                                          v.b_t,
                                          v.c_t,
                                          v.rho};
               });
    return ExitCode::done;
  });
}

}  // namespace magicmass::command
