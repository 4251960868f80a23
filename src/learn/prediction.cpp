// SPDX-License-Identifier: GPL-2.0-or-later
// Predictions: a number, or one of several choices, held against what the program computes.
#include <algorithm>
#include <sstream>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "equality/constant.hpp"
#include "learn/terms.hpp"

namespace learn {
namespace {

std::optional<int> sign_of(Expr constant) {
  if (!notation::symbols_of(constant).empty()) return {};
  try {
    return equality::exact_sign(constant);
  } catch (const equality::NotDefined&) {
    return -1;  // what has no value is not near
  }
}

bool holds(const Terms& terms, const std::string& conditions) {
  std::istringstream parts(conditions);
  for (std::string part; std::getline(parts, part, ',');)
    for (const auto& [left, relation, right] : notation::read_comparisons(part).comparisons) {
      const auto sign = sign_of(terms.in_full(left - right));
      if (!sign) throw answers::InvalidInput("when: " + part + ": not decided");
      const bool is_true = *sign == 0 ? relation == "=" || relation == "<=" || relation == ">="
                                      : relation == "!=" || relation[0] == (*sign < 0 ? '<' : '>');
      if (!is_true) return false;
    }
  return true;
}

Judgement judge_choice(const Exercise& e, const std::string& text) {
  const std::size_t first = std::min(text.find_first_not_of("( "), text.size() - 1);
  const bool is_letter = text.find_first_not_of(") .,:;", first + 1) == text.npos;  // (a), b., c
  const char letter = char(text[first] | 0x20);
  const char last = char('a' + e.choices.size() - 1);
  if (!is_letter || letter < 'a' || letter > last)
    kernel::refuse("one letter from a to " + std::string(1, last) + " is expected, got " +
                   answers::shown_text(text));
  if (letter == right_choice(e)) return {Mark::right, "Right: this is what happens."};
  for (const Misconception& one : e.misconceptions)
    for (const std::string& answer : one.answers)
      if (answer == std::string(1, letter)) return {Mark::wrong, one.feedback};
  return {Mark::wrong, "This is not what happens."};
}

}  // namespace

char right_choice(const Exercise& e) {
  if (e.when.empty()) return e.answer.empty() ? '?' : e.answer[0];
  const Terms terms(e);
  std::string letters;
  for (std::size_t i = 0; i < e.when.size(); ++i)
    if (holds(terms, e.when[i])) letters += char('a' + i);
  if (letters.size() != 1)
    throw answers::InvalidInput("when: " + std::to_string(letters.size()) +
                                " choices are right, not one");
  return letters[0];
}

Judgement judge_prediction(const Exercise& e, const std::string& text) {
  if (!e.choices.empty()) return judge_choice(e, text);
  Judgement said;
  const Terms terms(e);
  const Expr typed = terms.typed_for_name(text, said.notes);
  if (const std::string foreign = terms.foreign(typed); !foreign.empty()) kernel::refuse(foreign);
  if (kernel::is_matrix(typed)) kernel::refuse("a number is asked for");
  const Expr given = terms.in_full(typed), expected = terms.in_full(terms.answer());
  const Judgement compared = terms.compare(given, expected);
  said.mark = compared.mark;
  said.feedback = said.mark == Mark::right ? "Right: this is what happens." : compared.feedback;
  if (said.mark != Mark::wrong) return said;
  if (!e.within.empty()) {
    const Expr gap = notation::call("abs", given - expected);
    if (const auto sign = sign_of(terms.in_full(terms.content(e.within)) - gap); !sign)
      return {Mark::undecided, "It could not be decided whether yours is near enough.", said.notes};
    else if (*sign >= 0)
      return {Mark::right, "Right: near enough.", said.notes};
  }
  const std::string known = misconception_of(terms, given);
  if (!known.empty()) said.feedback = known;
  return said;
}

}  // namespace learn
