// SPDX-License-Identifier: GPL-2.0-or-later
// One of several choices, held against what the program computes.
#include <algorithm>

#include "answers/errors.hpp"
#include "answers/shown_text.hpp"
#include "learn/terms.hpp"

namespace learn {
namespace {

bool are_true(const Terms& terms, const std::string& conditions) {
  for (const std::string& part : split(conditions, ','))
    for (const auto& [left, relation, right] : notation::read_comparisons(part)) {
      const auto is_true = equality::holds({terms.in_full(left), relation, terms.in_full(right)});
      if (!is_true) throw answers::InvalidInput("when: " + part + ": not decided");
      if (!*is_true) return false;
    }
  return true;
}

}  // namespace

char right_choice(const Exercise& e) {
  if (e.when.empty()) return e.answer.empty() ? '?' : e.answer[0];
  const Terms terms(e);
  std::string letters;
  for (std::size_t i = 0; i < e.when.size(); ++i)
    if (are_true(terms, e.when[i])) letters += char('a' + i);
  if (letters.size() != 1)
    throw answers::InvalidInput("when: " + std::to_string(letters.size()) +
                                " choices are right, not one");
  return letters[0];
}

Judgement judge_choice(const Exercise& e, const std::string& text) {
  const std::size_t first = std::min(text.find_first_not_of("( "), text.size() - 1);
  const std::size_t after = text.find_first_not_of(") .,:;", first + 1);  // (a), b., c
  const char letter = char(text[first] | 0x20);
  const char last = char('a' + e.choices.size() - 1);
  if (letter < 'a' || letter > last ||
      (after != text.npos && text.substr(after) != e.choices[std::size_t(letter - 'a')]))
    kernel::refuse("one letter from a to " + std::string(1, last) + " is expected, got " +
                   answers::shown_text(text));
  if (letter == right_choice(e)) return {Mark::right, happens};
  const auto was_given = [&](const std::string& answer) {
    return answer == std::string(1, letter);
  };
  return mistake(e, was_given, "This is not what happens.");
}

}  // namespace learn
