// SPDX-License-Identifier: GPL-2.0-or-later
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "command/alpha_value.hpp"
#include "command/commands.hpp"
#include "command/inelastic_end.hpp"
#include "command/program.hpp"
#include "command/questions.hpp"
#include "command/velocity_tiers.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"

namespace magicmass::command {
namespace {

struct TerminalOptions {
  QuestionOptions asked;
  AccuracyOptions accuracy;
  std::string restitution = "1";
  OutputOptions output;
};

const std::vector<std::string> elastic_columns{"alpha", "N_A", "N_B", "a_t", "b_t", "c_t", "rho"};

void answer_elastic(const TerminalOptions& options) {
  const Accuracy wanted = accuracy(options.accuracy);
  answer_all(options.asked, false, options.output, elastic_columns, [&](const Question& question) {
    const MassRatio alpha = parse_mass_ratio(question.alpha);
    const reference::LargeCounts counts = reference::count_collisions(alpha);
    const TerminalCells v = terminal_velocities(alpha, counts, wanted);
    return std::vector<Cell>{alpha_cell(alpha),
                             digits_cell(reference::to_text(counts.N_A)),
                             digits_cell(reference::to_text(counts.N_B)),
                             v.a_t,
                             v.b_t,
                             v.c_t,
                             v.rho};
  });
}

void say_that_they_never_end(const TerminalOptions& options, std::size_t collapses, double time) {
  if (collapses == 0) return;
  const std::string where = options.asked.input ? fmt::format("collapse in {} rows: ", collapses)
                                                : fmt::format("collapse at t = {} L/V: ", time);
  std::cerr << "magicmass: note: " + where +
                   "infinitely many collisions in a finite time, so none is the last\n";
}

void answer_inelastic(const TerminalOptions& options, const cln::cl_RA& e) {
  if (accuracy(options.accuracy).tier != "fast")
    throw InvalidInput(
        "--tier accurate, exact and --digits go with restitution 1; allowed here: --tier fast");
  std::vector<std::string> columns = elastic_columns;
  columns.insert(columns.end(), {"restitution", "status", "t_collapse"});
  std::size_t collapses = 0;
  double time = 0.0;
  answer_all(options.asked, false, options.output, columns, [&](const Question& question) {
    const MassRatio alpha = parse_mass_ratio(question.alpha);
    const InelasticEnd end = inelastic_end(alpha, e);
    std::vector<Cell> cells{alpha_cell(alpha)};
    if (end.counts) {
      const auto& v = end.terminal;
      cells.insert(cells.end(),
                   {digits_cell(reference::to_text(end.counts->N_A)),
                    digits_cell(reference::to_text(end.counts->N_B)), number_cell(v.a_t),
                    number_cell(v.b_t), number_cell(v.c_t), number_cell(v.rho)});
    } else {
      cells.insert(cells.end(), 6, missing_cell());
      time = end.collapse_time;
      ++collapses;
    }
    const MassRatio written = parse_mass_ratio(options.restitution);
    cells.insert(cells.end(), {alpha_cell(written), text_cell(end.counts ? "complete" : "collapse"),
                               end.counts ? missing_cell() : number_cell(end.collapse_time)});
    return cells;
  });
  say_that_they_never_end(options, collapses, time);
}

}  // namespace

void add_terminal(Program& program) {
  const auto options = std::make_shared<TerminalOptions>();
  CLI::App& command =
      add_command(program, "terminal", "Velocities after the last collision, and the energy B got",
                  "magicmass terminal --alpha 0.12\n"
                  "  magicmass terminal --alpha 0.12 --restitution 0.9");
  add_question_options(command, options->asked);
  command
      .add_option("--restitution", options->restitution,
                  "0 < E <= 1; below 1 adds status and t_collapse")
      ->type_name("E");
  add_accuracy_options(command, options->accuracy);
  add_output_options(command, options->output);
  command.footer(
      "status is complete or collapse: infinitely many collisions in the time\n"
      "t_collapse, in L/V, so no counts and no last velocities; exit code 0, too.");
  on_run(program, command, [options] {
    const cln::cl_RA e = parse_restitution(options->restitution);
    if (e == 1)
      answer_elastic(*options);
    else
      answer_inelastic(*options, e);
    return ExitCode::done;
  });
}

}  // namespace magicmass::command
