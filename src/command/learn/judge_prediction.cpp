// SPDX-License-Identifier: GPL-2.0-or-later
#include <cctype>

#include <fmt/format.h>

#include "command/learn/expressions.hpp"
#include "command/learn/judgement.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/shown_text.hpp"

namespace magicmass::command {
namespace {

using equality::Answer;
using equality::Tree;

char letter_of(std::size_t choice) { return static_cast<char>('a' + choice); }

Judgement judge_choice(const Posed& posed, const std::string& typed) {
  const auto& choices = posed.exercise.choices;
  const char letter = static_cast<char>(std::tolower(static_cast<unsigned char>(typed[0])));
  const auto index = static_cast<std::size_t>(letter - 'a');
  const bool is_letter = typed.size() == 1 || (typed.size() == 2 && typed[1] == ')');
  if (!is_letter || letter < 'a' || index >= choices.size())
    return unread(fmt::format("one letter from a to {} is expected, got {}",
                              letter_of(choices.size() - 1), shown_text(typed)));
  const std::string place = (posed.exercise.folder / "exercise.toml").string() + ": choices";
  Judgement judgement;
  judgement.read_as = {fmt::format("{}) {}", letter, choices[index].text)};
  const bool is_right = holds(choices[index].when, posed.values, place);
  judgement.verdict = is_right ? Judged::right : Judged::wrong;
  judgement.said = is_right ? "Right: this is what happens." : "This is not what happens.";
  if (is_right) return judgement;
  for (const Misconception& one : posed.exercise.misconceptions)
    for (const std::string& text : one.answers)
      if (text == std::string(1, letter)) {
        judgement.misconception = one.name;
        judgement.explanation = one.feedback;
        return judgement;
      }
  return judgement;
}

/// Whether left <= right for constants: right - left is its own absolute value.
equality::Verdict at_most(const Tree& left, const Tree& right) {
  const Tree gap = equality::difference(right, left);
  return decided(equality::function("abs", gap), gap, {});
}

}  // namespace

Judgement judge_prediction(const Posed& posed, const std::string& typed,
                           const render::TextStyle& style) {
  const Exercise& exercise = posed.exercise;
  if (!exercise.choices.empty()) return judge_choice(posed, typed);
  const Tree answer = read_answer(typed, posed.allowed_symbols());
  const Tree given = with_values(answer, posed.values);
  if (!given->is_constant)
    return unread("a number is expected; " + *equality::symbols_of(given).begin() +
                  " has no value here");
  const std::string place = (exercise.folder / "solution/answer.txt").string();
  const Tree truth = with_values(read_content(posed.solution, place), posed.values);
  Judgement judgement;
  judgement.read_as = {shown(answer, style)};
  equality::Verdict verdict;
  if (exercise.within.empty()) {
    verdict = decided(given, truth, {});
  } else {
    const Tree within = with_values(read_content(exercise.within, place), posed.values);
    verdict = at_most(equality::function("abs", equality::difference(given, truth)), within);
  }
  if (verdict.answer == Answer::undecided) {
    judgement.said = "Undecided: " + verdict.proof + ". Please write it as a plain number.";
    return judgement;
  }
  const bool is_right = verdict.answer == Answer::equal;
  judgement.verdict = is_right ? Judged::right : Judged::wrong;
  judgement.said = is_right ? "Right: this is what happens." : "This is not what happens.";
  if (is_right) return judgement;
  const std::string source = (exercise.folder / "misconceptions.toml").string();
  for (const Misconception& one : exercise.misconceptions)
    for (const std::string& text : one.answers)
      if (are_equal(given, with_values(read_content(text, source), posed.values), {})) {
        judgement.misconception = one.name;
        judgement.explanation = one.feedback;
        return judgement;
      }
  if (const auto sides = decided(given, truth, {}).counterexample)
    judgement.explanation = shown(*sides);
  return judgement;
}

}  // namespace magicmass::command
