// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/count.hpp"

#include <memory>

#include "command/alpha_value.hpp"
#include "command/commands.hpp"
#include "command/questions.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::command {
namespace {

struct CountOptions {
  QuestionOptions asked;
  OutputOptions output;
};

std::vector<Cell> count(const Question& question) {
  const MassRatio alpha = parse_mass_ratio(question.alpha);
  const reference::LargeCounts counts = reference::exact_counts(alpha);
  return {alpha_cell(alpha), digits_cell(reference::to_text(counts.N_A)),
          digits_cell(reference::to_text(counts.N_B))};
}

}  // namespace

void add_count(Program& program) {
  const auto options = std::make_shared<CountOptions>();
  CLI::App& command =
      add_command(program, "count", "Number of collisions of each block, exact at any size",
                  "magicmass count --alpha magic:3");
  add_question_options(command, options->asked);
  add_output_options(command, options->output);
  on_run(program, command, [options] {
    answer_all(options->asked, false, options->output, {"alpha", "N_A", "N_B"}, count);
    return ExitCode::done;
  });
}

}  // namespace magicmass::command
