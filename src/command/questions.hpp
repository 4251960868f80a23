// SPDX-License-Identifier: GPL-2.0-or-later
// What eval, count and terminal are asked: one alpha on the command line, or a CSV file of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "command/records.hpp"

namespace CLI {
class App;
}

namespace magicmass::command {

/// --alpha, --n and --input as they were given.
struct QuestionOptions {
  std::optional<std::string> alpha;
  std::optional<std::string> n;
  std::optional<std::string> input;
};

/// Adds --alpha and --input.
void add_question_options(CLI::App& command, QuestionOptions& options);

/// Texts, not yet read as numbers, and where they stand: "rows.csv:3: ", or nothing for the command line.
struct Question {
  std::string place;
  std::string alpha;
  std::string n;
};

/// All questions in order. n may come from a column or from --n where `with_n`.
/// Throws InvalidInput: which file, line and column, and what is allowed.
std::vector<Question> questions(const QuestionOptions& options, bool with_n);

/// Answers all questions, then writes all answers: an error in one leaves no output. Errors name the place.
void answer_all(const QuestionOptions& asked, bool with_n, const OutputOptions& options,
                const std::vector<std::string>& columns,
                const std::function<std::vector<Cell>(const Question&)>& answer);

}  // namespace magicmass::command
