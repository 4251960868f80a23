// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/judgement.hpp"

#include <cctype>
#include <sstream>

#include "command/learn/expressions.hpp"
#include "command/learn/own_answer.hpp"
#include "command/learn/variant.hpp"

namespace magicmass::command {

std::string name_of(Judged verdict) {
  switch (verdict) {
    case Judged::right:
      return "right";
    case Judged::form:
      return "form";
    case Judged::wrong:
      return "wrong";
    case Judged::undecided:
      return "undecided";
    case Judged::unread:
      break;
  }
  return "unread";
}

Posed posed(const Exercise& exercise, const Values& variant) {
  Posed posed{filled(exercise, variant), variant, variant, ""};
  if (exercise.kind != ExerciseKind::code)  // whose cases run the program one by one
    posed.values.merge(computed_values(posed.exercise, variant));
  posed.solution = text_of(exercise.folder / "solution" / exercise.answer_file());
  if (exercise.kind != ExerciseKind::code)
    posed.solution = filled(without_remarks(posed.solution), posed.values);
  return posed;
}

std::string without_remarks(const std::string& text) {
  std::istringstream lines(text);
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#') continue;
    kept +=
        (kept.empty() ? "" : "\n") + line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
  }
  return kept;
}

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

Judgement unread(const std::string& why) {
  return {.verdict = Judged::unread, .said = "This could not be read: " + why + "."};
}

Judgement judge(const Posed& posed, const std::string& answer, const render::TextStyle& style) {
  constexpr std::size_t longest = 20000;
  const Exercise& exercise = posed.exercise;
  if (exercise.kind == ExerciseKind::code) return judge_code(posed, answer);
  if (answer.size() > longest) return unread("it is longer than 20000 characters");
  const std::string typed = without_remarks(answer);
  if (typed.empty()) return {.verdict = Judged::unread, .said = "There is no answer yet."};
  try {
    if (exercise.kind == ExerciseKind::predict) return judge_prediction(posed, typed, style);
    if (exercise.shape == Shape::derivation || exercise.shape == Shape::equations)
      return judge_lines(posed, typed, style);
    return judge_symbolic(posed, typed, style);
  } catch (const NotUnderstood& error) {
    return unread(error.what());
  }
}

}  // namespace magicmass::command
