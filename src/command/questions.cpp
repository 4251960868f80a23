// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/questions.hpp"

#include <utility>

#include "command/csv_table.hpp"
#include "command/program.hpp"
#include "magicmass/errors.hpp"

namespace magicmass::command {
namespace {

void require_given_once(const QuestionOptions& options, bool with_n) {
  if (options.alpha && options.input)
    throw InvalidInput("--alpha and --input exclude each other; give one of them");
  if (!options.alpha && !options.input)
    throw InvalidInput("nothing to compute: give --alpha A or --input FILE.csv");
  if (options.alpha && with_n && !options.n) throw InvalidInput("--n is missing: give --n N");
}

}  // namespace

void add_question_options(CLI::App& command, QuestionOptions& options) {
  command
      .add_option_function<std::string>(
          "--alpha", [&options](const std::string& text) { options.alpha = text; },
          "ball mass / block mass: 0.1, 1/7, magic:3, ...")
      ->type_name("A");
  command
      .add_option_function<std::string>(
          "--input", [&options](const std::string& text) { options.input = text; },
          "many at once, from a CSV file (- is stdin)")
      ->type_name("FILE.csv");
}

std::vector<Question> questions(const QuestionOptions& options, bool with_n) {
  require_given_once(options, with_n);
  if (options.alpha) return {{"", *options.alpha, options.n.value_or("")}};
  const std::vector<std::string> allowed =
      with_n ? std::vector<std::string>{"alpha,n", "alpha"} : std::vector<std::string>{"alpha"};
  const CsvTable table = read_csv(*options.input, allowed);
  const bool n_in_table = table.header == "alpha,n";
  if (n_in_table && options.n)
    throw InvalidInput(table.source + ":1: n: the file has a column n, so --n must not be given");
  if (with_n && !n_in_table && !options.n)
    throw InvalidInput(table.source +
                       ":1: n: no such column; allowed: the header alpha,n, or --n N");
  std::vector<Question> asked;
  for (const CsvRow& row : table.rows)
    asked.push_back({table.source + ":" + std::to_string(row.line) + ": ", row.fields.front(),
                     n_in_table ? row.fields.back() : options.n.value_or("")});
  return asked;
}

void answer_all(const QuestionOptions& asked, bool with_n, const OutputOptions& options,
                const std::vector<std::string>& columns,
                const std::function<std::vector<Cell>(const Question&)>& answer) {
  std::vector<std::vector<Cell>> answers;
  for (const Question& question : questions(asked, with_n)) {
    try {
      answers.push_back(answer(question));
    } catch (const InvalidInput& error) {
      throw InvalidInput(question.place + error.what());
    } catch (const Undecided& error) {
      throw Undecided(question.place + error.what());
    }
  }
  Destination output(options.path);
  RecordWriter writer(output, options.format, columns, !asked.input);
  for (const std::vector<Cell>& cells : answers) writer.write(cells);
  writer.finish();
  output.finish();
}

}  // namespace magicmass::command
