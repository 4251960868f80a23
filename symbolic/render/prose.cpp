// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/prose.hpp"

#include <algorithm>
#include <cctype>

#include "render/notation.hpp"

namespace magicmass::render {
namespace {

constexpr std::string_view opening = "([";
constexpr std::string_view closing = ")].,;:?";

void append_words(Prose& result, std::string_view words) {
  if (words.empty()) return;
  if (result.empty() || result.back().is_formula) result.push_back({});
  result.back().words += words;
}

void append(Prose& result, Formula formula, std::string_view written) {
  result.push_back(
      {.is_formula = true, .words = std::string(written), .formula = std::move(formula)});
}

/// No English word looks like this: V_CM, Lambda^n, sqrt(alpha), psi; nor does a single letter, save the names of
/// the bodies and the article.
bool looks_like_formula(std::string_view word) {
  if (word.find_first_of("_^") != std::string_view::npos) return true;
  if (word.size() == 1)
    return std::isalpha(static_cast<unsigned char>(word[0])) != 0 &&
           std::string_view("aABCI").find(word[0]) == std::string_view::npos;
  const std::size_t bracket = word.find('(');
  if (bracket != std::string_view::npos && bracket > 0 && word.ends_with(')'))
    return looks_like_symbol(word.substr(0, bracket)) || is_function_name(word.substr(0, bracket));
  return unicode_letter(word) != word;
}

/// a_(n-1) is written without blanks among words.
std::string spaced(std::string_view word) {
  std::string result;
  bool index = false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    index = index ? word[i] != ')' : word.substr(i, 2) == "_(";
    const bool apart = index && (word[i] == '-' || word[i] == '+') && word[i - 1] != '(';
    result += apart ? std::string(" ") + word[i] + " " : std::string(1, word[i]);
  }
  return result;
}

void append_word(Prose& result, std::string_view word) {
  std::size_t begin = 0;
  std::size_t end = word.size();
  while (begin < end && opening.find(word[begin]) != std::string_view::npos) ++begin;
  while (end > begin) {
    const std::string_view inside = word.substr(begin, end - begin);
    const bool balanced = std::count(inside.begin(), inside.end(), '(') >=
                          std::count(inside.begin(), inside.end(), ')');
    if (closing.find(word[end - 1]) == std::string_view::npos || (word[end - 1] == ')' && balanced))
      break;
    --end;
  }
  const std::string_view inside = word.substr(begin, end - begin);
  const auto read = looks_like_formula(inside) ? read_formula(spaced(inside)) : std::nullopt;
  if (!read) return append_words(result, word);
  append_words(result, word.substr(0, begin));
  append(result, *read, inside);
  append_words(result, word.substr(end));
}

/// Behind the parenthesis that closes the one at `begin`, if there are several words between them; else `begin`.
std::size_t end_of_parentheses(std::string_view clause, std::size_t begin) {
  if (begin >= clause.size() || clause[begin] != '(') return begin;
  int depth = 0;
  for (std::size_t i = begin; i < clause.size(); ++i) {
    if (clause[i] == '(') ++depth;
    if (clause[i] == ')' && --depth == 0)
      return clause.substr(begin, i - begin).find(' ') == std::string_view::npos ? begin : i + 1;
  }
  return begin;
}

void append_clause(Prose& result, std::string_view clause) {
  if (auto relation = read_relation(clause)) return append(result, std::move(*relation), clause);
  for (const std::string_view between : {" for every ", " or "}) {
    const std::size_t end = clause.find(between);
    if (end == std::string_view::npos || !read_relation(clause.substr(0, end))) continue;
    append_clause(result, clause.substr(0, end));
    append_words(result, between);
    return append_clause(result, clause.substr(end + between.size()));
  }
  std::size_t begin = 0;
  while (begin <= clause.size()) {
    if (const std::size_t end = end_of_parentheses(clause, begin); end > begin) {
      const auto inside = read_formula(clause.substr(begin, end - begin));
      if (inside && inside->kind == Formula::Kind::list)
        append(result, *inside, clause.substr(begin, end - begin));
      if (inside && inside->kind != Formula::Kind::list) {
        append_words(result, "(");
        append(result, *inside, clause.substr(begin + 1, end - begin - 2));
        append_words(result, ")");
      }
      if (inside) begin = end;
    }
    const std::size_t end = std::min(clause.find(' ', begin), clause.size());
    append_word(result, clause.substr(begin, end - begin));
    if (end < clause.size()) append_words(result, " ");
    begin = end + 1;
  }
}

}  // namespace

Prose prose(std::string_view words) {
  Prose result;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (opening.find(words[i]) != std::string_view::npos) ++depth;
    if (words[i] == ')' || words[i] == ']') --depth;
    const bool ends = depth == 0 && i + 1 < words.size() && words[i + 1] == ' ' &&
                      std::string_view(",;:").find(words[i]) != std::string_view::npos;
    if (!ends) continue;
    append_clause(result, words.substr(begin, i - begin));
    append_words(result, words.substr(i, 2));
    begin = i + 2;
  }
  append_clause(result, words.substr(begin));
  return result;
}

}  // namespace magicmass::render
