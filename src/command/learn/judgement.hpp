// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "command/learn/exercise.hpp"
#include "render/formula_text.hpp"

namespace magicmass::command {

/// What is said of an answer. Never a guess: right is proved, wrong has a counterexample.
enum class Judged {
  right,
  form,  ///< right, but not in the form that was asked for
  wrong,
  undecided,
  unread,  ///< it could not be read, so it is no attempt
};

std::string name_of(Judged verdict);  ///< "right", ...

struct Judgement {
  Judged verdict = Judged::undecided;
  std::vector<std::string> read_as = {};  ///< how it was understood, line by line
  std::string said = {};                  ///< the verdict in a sentence
  std::string misconception = {};         ///< the name of the one that was recognised
  std::string explanation = {};           ///< its words, or the counterexample
};

/// An exercise with a student's variant, its texts filled in and the program's own answer at hand.
struct Posed {
  Exercise exercise;
  Values variant;
  Values values;  ///< the variant's and those of `run`
  std::string solution;

  /// Those that an answer may have: the exercise's and its variant's names; none: any.
  std::vector<std::string> allowed_symbols() const {
    std::vector<std::string> allowed = exercise.symbols;
    if (!allowed.empty())
      for (const auto& [name, value] : variant) allowed.push_back(name);
    return allowed;
  }
};

/// Throws InvalidInput where the exercise's files do not give all that.
Posed posed(const Exercise& exercise, const Values& variant);

Judgement judge(const Posed& posed, const std::string& answer, const render::TextStyle& style);

Judgement judge_symbolic(const Posed& posed, const std::string& answer,
                         const render::TextStyle& style);
Judgement judge_lines(const Posed& posed, const std::string& answer,
                      const render::TextStyle& style);
Judgement judge_prediction(const Posed& posed, const std::string& answer,
                           const render::TextStyle& style);
Judgement judge_code(const Posed& posed, const std::string& program);

/// The solution as one writes it who has the misconception, which has a `replace`.
std::string replaced_solution(const Posed& posed, const Misconception& misconception);

/// What is typed in an answer file: without lines that begin with #.
std::string without_remarks(const std::string& text);

/// With a capital as its first letter.
std::string capitalised(std::string text);

Judgement unread(const std::string& why);

}  // namespace magicmass::command
