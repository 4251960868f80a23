// SPDX-License-Identifier: GPL-2.0-or-later
#include "magicmass/reference/count.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "command/alpha_value.hpp"
#include "command/commands.hpp"
#include "command/program.hpp"
#include "command/questions.hpp"
#include "magicmass/evaluators/count_decision.hpp"
#include "magicmass/nearest_threshold.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::command {
namespace {

struct CountOptions {
  QuestionOptions asked;
  bool near_tie = false;
  OutputOptions output;
};

bool is_threshold(const MassRatio& alpha) {
  return std::holds_alternative<Magic>(alpha) || std::holds_alternative<Deficient>(alpha);
}

/// Where it is one, as 1/2 is, too.
std::optional<double> as_double(const MassRatio& alpha) {
  if (const auto* value = std::get_if<double>(&alpha)) return *value;
  const auto exact = *reference::exact(alpha);
  const auto nearest = reference::nearest<double>(exact);
  if (nearest > 0 && std::isfinite(nearest) && reference::exact(nearest) == exact) return nearest;
  return std::nullopt;
}

/// Whether it is a threshold, or long double could not have told the count, which threshold is the closest, and how
/// close. Not known of a ratio that is neither a double nor a threshold itself, nor where the counts do not fit 64 bits.
std::vector<Cell> near_tie_cells(const MassRatio& alpha) {
  const auto truth = [](bool value) { return Cell{value ? "true" : "false", false}; };
  if (is_threshold(alpha)) return {truth(true), text_cell(to_text(alpha)), number_cell(0.0)};
  if (const std::optional<double> value = as_double(alpha))
    if (const auto nearest = nearest_threshold(*value))
      return {truth(decide_count(*value).near_tie || nearest->distance == 0.0),
              text_cell((nearest->is_magic ? "magic:" : "deficient:") + std::to_string(nearest->k)),
              number_cell(nearest->distance)};
  return std::vector<Cell>(3, missing_cell());
}

std::vector<Cell> count(const Question& question, bool with_near_tie) {
  const MassRatio alpha = parse_mass_ratio(question.alpha);
  const reference::LargeCounts counts = reference::count_collisions(alpha);
  std::vector<Cell> cells{alpha_cell(alpha), digits_cell(reference::to_text(counts.N_A)),
                          digits_cell(reference::to_text(counts.N_B))};
  if (with_near_tie)
    for (Cell& cell : near_tie_cells(alpha)) cells.push_back(std::move(cell));
  return cells;
}

}  // namespace

void add_count(Program& program) {
  const auto options = std::make_shared<CountOptions>();
  CLI::App& command =
      add_command(program, "count", "Number of collisions of each block, exact at any size",
                  "magicmass count --alpha magic:3\n"
                  "  magicmass count --alpha 0x1.1c7397cb68b7ep-18 --near-tie");
  add_question_options(command, options->asked);
  command.add_flag("--near-tie", options->near_tie,
                   "also the closest threshold, and how close alpha is");
  add_output_options(command, options->output);
  command.footer(
      "near_tie: alpha is a threshold, or long double could not have told the\n"
      "count. distance is (alpha - threshold)/threshold. All three are null where\n"
      "alpha is neither a double nor a threshold, and where the counts do not fit\n"
      "64 bits.");
  on_run(program, command, [options] {
    std::vector<std::string> columns{"alpha", "N_A", "N_B"};
    if (options->near_tie) columns.insert(columns.end(), {"near_tie", "threshold", "distance"});
    answer_all(options->asked, false, options->output, columns,
               [&](const Question& question) { return count(question, options->near_tie); });
    return ExitCode::done;
  });
}

}  // namespace magicmass::command
