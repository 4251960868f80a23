// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cstddef>
#include <iostream>
#include <memory>

#include <cln/integer_io.h>

#include "command/alpha_value.hpp"
#include "command/commands.hpp"
#include "command/program.hpp"
#include "command/questions.hpp"
#include "command/velocity_tiers.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/reference/count.hpp"
#include "magicmass/reference/rational.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

struct EvalOptions {
  QuestionOptions asked;
  AccuracyOptions accuracy;
  OutputOptions output;
};

cln::cl_I parse_cycle_index(const std::string& text) {
  const bool is_whole =
      !text.empty() && text.size() <= longest_mass_ratio_text &&
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!is_whole) throw InvalidInput("n must be a whole number, 0 or more, got " + shown_text(text));
  return cln::numerator(reference::parse_rational(text));
}

void require_not_beyond(const cln::cl_I& n, const cln::cl_I& N_A, const MassRatio& alpha) {
  if (n > N_A)
    throw InvalidInput("n = " + reference::to_text(n) + " is beyond the last collision: N_A = " +
                       reference::to_text(N_A) + " at alpha = " + shown_text(to_text(alpha)) +
                       "; the formula goes on, physics does not");
}

/// Q_(N_A) does not happen where N_A = N_B + 1, yet b_n and c'_n have values there.
void say_where_only_the_formula_goes_on(std::size_t answers) {
  if (answers > 0)
    std::cerr << "magicmass: note: B is not hit an n-th time" +
                     (answers == 1 ? std::string() : " in " + std::to_string(answers) + " rows") +
                     " (N_B = n - 1): b and c_prime are the formula's alone\n";
}

}  // namespace

void add_eval(Program& program) {
  const auto options = std::make_shared<EvalOptions>();
  CLI::App& command = add_command(
      program, "eval", "Velocities after the n-th collision of each block, in units of V",
      "magicmass eval --alpha 1/7 --n 2 --tier exact\n"
      "  magicmass eval --alpha magic:3 --n 2 --digits 50 --format json");
  add_question_options(command, options->asked);
  command
      .add_option_function<std::string>(
          "--n", [options](const std::string& text) { options->asked.n = text; },
          "which collision, 0 (before the first) to N_A")
      ->type_name("N");
  add_accuracy_options(command, options->accuracy);
  add_output_options(command, options->output);
  on_run(program, command, [options] {
    const Accuracy wanted = accuracy(options->accuracy);
    std::size_t only_formula = 0;
    answer_all(options->asked, true, options->output,
               {"alpha", "n", "tier", "a", "b", "c", "c_prime"}, [&](const Question& question) {
                 const MassRatio alpha = parse_mass_ratio(question.alpha);
                 const cln::cl_I n = parse_cycle_index(question.n);
                 const reference::LargeCounts counts = reference::count_collisions(alpha);
                 require_not_beyond(n, counts.N_A, alpha);
                 if (n > counts.N_B) ++only_formula;
                 const VelocityCells v = velocities(alpha, n, wanted);
                 return std::vector<Cell>{alpha_cell(alpha),
                                          digits_cell(reference::to_text(n)),
                                          text_cell(wanted.tier),
                                          v.a,
                                          v.b,
                                          v.c,
                                          v.c_prime};
               });
    say_where_only_the_formula_goes_on(only_formula);
    return ExitCode::done;
  });
}

}  // namespace magicmass::command
