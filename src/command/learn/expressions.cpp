// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/expressions.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include <fmt/format.h>

#include "equality/constant.hpp"
#include "equality/evaluate.hpp"
#include "equality/point.hpp"
#include "equality/typed_text.hpp"
#include "magicmass/errors.hpp"
#include "magicmass/scenes/nearest_key.hpp"
#include "magicmass/scenes/shown_text.hpp"
#include "render/formula.hpp"

namespace magicmass::command {

using equality::Tree;

namespace {

constexpr equality::Bounds answer_bounds{std::chrono::milliseconds(3000), std::size_t{400} << 20U};

std::string nearest(const std::string& name, const std::vector<std::string>& allowed) {
  for (const std::string& known : allowed)
    if (name.size() > 2 && edit_distance(name, known) <= 2) return known;
  return {};
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// M_1u_1 as "M_1 u_1": the longest names first; empty where it is no such thing.
std::string taken_apart(const std::string& word, const std::vector<std::string>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), word) != allowed.end()) return word;
  for (std::size_t length = word.size() - 1; length > 0; --length) {
    const std::string first = word.substr(0, length);
    if (std::find(allowed.begin(), allowed.end(), first) == allowed.end()) continue;
    const std::string rest = taken_apart(word.substr(length), allowed);
    if (!rest.empty()) return first + " " + rest;
  }
  return {};
}

/// Names that are written without a blank between them, as LaTeX allows it.
std::string with_blanks(const std::string& text, const std::vector<std::string>& allowed) {
  std::string result;
  std::string word;
  const auto end_word = [&] {
    const std::string apart = word.empty() || word.size() > 60 ? "" : taken_apart(word, allowed);
    result += apart.empty() ? word : apart;
    word.clear();
  };
  for (const char c : text) {
    if (is_word(c) && !(word.empty() && std::isdigit(static_cast<unsigned char>(c)) != 0)) {
      word += c;
      continue;
    }
    end_word();
    result += c;
  }
  end_word();
  return result;
}

/// Whether each name in a condition is a symbol of the question.
bool speaks_of_these(const std::string& condition, const std::set<std::string>& symbols) {
  std::string word;
  for (std::size_t i = 0; i <= condition.size(); ++i) {
    const char c = i < condition.size() ? condition[i] : ' ';
    if (is_word(c)) {
      word += c;
      continue;
    }
    const bool is_name = !word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) == 0;
    if (is_name && word != "integer" && word != "real" && word != "pi" && !symbols.contains(word))
      return false;
    word.clear();
  }
  return true;
}

/// At most eight digits after the point, with dots where there were more.
std::string shortened(const std::string& number) {
  const std::size_t point = number.find('.');
  if (point == std::string::npos || number.size() < point + 9 ||
      number.find_first_not_of("-0123456789.") != std::string::npos)
    return number;
  return number.substr(0, point + 7) + "...";
}

}  // namespace

Tree read_answer(const std::string& typed, const std::vector<std::string>& allowed) {
  Tree tree;
  try {
    tree = equality::parse(with_blanks(equality::plain_text(typed), allowed),
                           {.characters = 4000, .nesting = 60, .nodes = 1500, .symbols = allowed});
  } catch (const equality::NotAnExpression& error) {
    throw NotUnderstood(error.what());
  }
  if (allowed.empty()) return tree;
  for (const std::string& name : equality::symbols_of(tree)) {
    if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) continue;
    const std::string meant = nearest(name, allowed);
    throw NotUnderstood(fmt::format("{} is not among the symbols of this exercise: {}{}",
                                    shown_text(name), fmt::join(allowed, ", "),
                                    meant.empty() ? "" : "; did you mean " + meant + "?"));
  }
  return tree;
}

Tree read_content(const std::string& text, const std::string& place) {
  try {
    return equality::parse(equality::plain_text(text));
  } catch (const equality::NotAnExpression& error) {
    throw InvalidInput(place + ": \"" + shown_text(text, 200) + "\": " + error.what());
  }
}

Tree with_values(const Tree& tree, const Values& values) {
  Tree result = tree;
  for (int round = 0; round < 2; ++round) {  // before the meanings, and what they brought
    for (const auto& [name, value] : values)
      if (equality::symbols_of(result).contains(name))
        result = equality::substituted(result, name, read_content(value, name));
    result = equality::with_meanings(result);
  }
  return result;
}

Tree replaced(const Tree& tree, const Values& replace, const std::string& place) {
  Tree result = tree;
  for (const auto& [name, value] : replace)
    if (!equality::symbols_of(result).contains(name)) result = equality::with_meanings(result);
  for (const auto& [name, value] :
       replace)  // by way of names that nobody uses: a and b may change places
    result = equality::substituted(result, name, equality::symbol(name + "_replaced"));
  for (const auto& [name, value] : replace)
    result =
        equality::substituted(result, name + "_replaced", read_content(value, place + ": replace"));
  return result;
}

equality::Verdict decided(const Tree& left, const Tree& right,
                          const std::vector<std::string>& domain) {
  std::set<std::string> symbols = equality::symbols_of(left);
  equality::collect_symbols(right, symbols);
  equality::Question question{equality::to_text(left), equality::to_text(right), {}};
  for (const std::string& condition : domain)
    if (speaks_of_these(condition, symbols)) question.domain.push_back(condition);
  try {
    return equality::answer_within(question, answer_bounds);
  } catch (const equality::Refused& error) {
    equality::Verdict verdict;
    verdict.proof = error.what();
    return verdict;
  }
}

bool are_equal(const Tree& left, const Tree& right, const std::vector<std::string>& domain) {
  return decided(left, right, domain).answer == equality::Answer::equal;
}

bool holds(const std::string& relations, const Values& values, const std::string& place) {
  if (const std::size_t comma = relations.find(','); comma != std::string::npos)
    return holds(relations.substr(0, comma), values, place) &&
           holds(relations.substr(comma + 1), values, place);
  std::vector<equality::Comparison> comparisons;
  try {
    comparisons = equality::parse_comparisons(relations);
  } catch (const equality::NotAnExpression& error) {
    throw InvalidInput(place + ": \"" + shown_text(relations) + "\": " + error.what());
  }
  return std::all_of(comparisons.begin(), comparisons.end(), [&](const auto& comparison) {
    const Tree tree = equality::at(
        {}, with_values(equality::difference(comparison.left, comparison.right), values));
    if (!tree->is_constant)
      throw InvalidInput(place + ": \"" + shown_text(relations) +
                         "\": " + *equality::symbols_of(tree).begin() + " has no value");
    const auto sign =
        equality::sign(equality::evaluate_to(tree, 60, equality::exact_sign_or_nothing));
    const std::optional<int> exact = sign ? sign : equality::exact_sign_or_nothing(tree);
    if (!exact)
      throw InvalidInput(place + ": \"" + shown_text(relations) +
                         "\": it is not certain which side is larger");
    const int known = *exact;
    const std::string& relation = comparison.relation;
    if (relation == "=") return known == 0;
    if (relation == "!=") return known != 0;
    return known == 0 ? relation.size() == 2 : (known < 0) == (relation[0] == '<');
  });
}

std::string digits_of(const Tree& constant, int digits, const std::string& place) {
  if (!constant->is_constant)
    throw InvalidInput(place + ": " + *equality::symbols_of(constant).begin() + " has no value");
  const Tree folded = equality::at({}, constant);
  for (const int precision : {20, 400, 2000}) {  // more where huge numbers cancel
    const equality::Ball ball =
        equality::evaluate_to(folded, digits + precision, equality::exact_sign_or_nothing);
    if (equality::sign(ball)) return equality::shown(ball, digits);
  }
  return "0";
}

std::string shown(const Tree& tree, const render::TextStyle& style) {
  const std::string text = equality::to_text(tree);
  const auto formula = render::read_formula(text);
  return formula ? render::inline_text(*formula, style) : text;
}

std::string shown(const equality::Counterexample& counterexample) {
  std::string left = shortened(counterexample.left);
  std::string right = shortened(counterexample.right);
  if (left == right) {
    left = counterexample.left;
    right = counterexample.right;
  }
  if (counterexample.point.empty()) {
    const bool is_less = counterexample.difference.starts_with('-');
    return "yours is " + left +
           (counterexample.difference.empty() ? "."
            : is_less                         ? ", which is too small."
                                              : ", which is too large.");
  }
  std::string at;
  for (const auto& [name, value] : counterexample.point)
    at += (at.empty() ? "at " : ", ") + name + " = " + value;
  return at + " yours is " + left + ", where it should be " + right +
         (right.ends_with('.') ? "" : ".");
}

}  // namespace magicmass::command
