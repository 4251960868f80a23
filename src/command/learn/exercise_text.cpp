// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/exercise_text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <sstream>

#include "command/learn/expressions.hpp"
#include "command/learn/variant.hpp"
#include "magicmass/errors.hpp"
#include "render/wrapping.hpp"

namespace magicmass::command {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// No line ends at an operator.
std::string with_held_operators(std::string text) {
  for (std::size_t i = 1; i + 3 < text.size(); ++i)
    if (text[i] == ' ' && text[i + 2] == ' ' &&
        std::string("=+-<>").find(text[i + 1]) != std::string::npos)
      text[i] = text[i + 2] = render::held_blank;
  return text;
}

/// Calls `replace` with what stands in each pair of double braces.
template <class Replace>
std::string without_braces(const std::string& text, const Replace& replace) {
  std::string result;
  std::size_t at = 0;
  for (std::size_t open = 0; (open = text.find("{{", at)) != std::string::npos;) {
    const std::size_t close = text.find("}}", open);
    if (close == std::string::npos) throw InvalidInput("{{ without }}");
    result += with_held_operators(text.substr(at, open - at)) +
              replace(trimmed(text.substr(open + 2, close - open - 2)));
    at = close + 2;
  }
  return result + with_held_operators(text.substr(at));
}

struct Marked {
  std::string expression, number;
};

Marked split_at(const std::string& content, const std::string& mark) {
  const std::size_t at = content.rfind(mark);
  return {trimmed(content.substr(0, at)), trimmed(content.substr(at + mark.size()))};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool is_relation(const std::string& text) { return text.find_first_of("<>=") != std::string::npos; }

std::string held(std::string formula) {  // no line ends within a short formula
  if (formula.size() < 40) std::replace(formula.begin(), formula.end(), ' ', render::held_blank);
  return formula;
}

int number_of_digits(const std::string& text, const std::string& content) {
  constexpr int most = 100;
  int digits = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, digits);
  if (error != std::errc() || rest != end || digits < 1 || digits > most)
    throw InvalidInput("{{" + content + "}}: a number of digits from 1 to 100 is expected");
  return digits;
}

std::string set(const std::string& content, const Posed& posed, const render::TextStyle& style) {
  const auto formula = [&](const std::string& text) {
    return held(shown(read_content(text, "text"), style));
  };
  if (content == "answer") {
    const bool is_expression = posed.exercise.kind != ExerciseKind::code &&
                               posed.exercise.shape == Shape::expression &&
                               posed.exercise.choices.empty();
    return is_expression ? formula(posed.solution) : posed.solution;
  }
  if (has(content, " : ")) {
    const Marked parts = split_at(content, " : ");
    return digits_of(with_values(read_content(parts.expression, "text"), posed.values),
                     number_of_digits(parts.number, content), "text");
  }
  if (const auto value = posed.values.find(content); value != posed.values.end())
    return value->second;
  if (!is_relation(content)) return formula(content);
  std::string text;
  for (const equality::Comparison& one : equality::parse_comparisons(content))
    text += (text.empty() ? shown(one.left, style) : "") + " " + one.relation + " " +
            shown(one.right, style);
  return held(text);
}

std::string complaint_about_claim(const std::string& content, const Posed& posed) {
  if (content == "answer" || has(content, " : ") || !is_relation(content)) return {};
  for (const equality::Comparison& one : equality::parse_comparisons(content)) {
    const equality::Tree left = with_values(one.left, posed.values);
    const equality::Tree right = with_values(one.right, posed.values);
    const bool is_true =
        one.relation == "="
            ? are_equal(left, right, posed.exercise.domain)
            : holds(equality::to_text(left) + one.relation + equality::to_text(right), {}, "text");
    if (!is_true) return "{{" + content + "}} is not proved";
  }
  return {};
}

bool is_typed_decimal(const std::string& text) {
  for (std::size_t i = 1; i + 1 < text.size(); ++i)
    if (text[i] == '.' && std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0 &&
        std::isdigit(static_cast<unsigned char>(text[i + 1])) != 0)
      return true;
  return false;
}

}  // namespace

std::string page_of(const std::string& markdown, const Posed& posed,
                    const render::TextStyle& style) {
  std::istringstream lines(filled(markdown, posed.values));
  std::string page;
  std::string paragraph;
  std::string first;
  const auto end_paragraph = [&] {
    if (!paragraph.empty())
      page += render::wrapped_sentences(
          without_braces(paragraph,
                         [&](const std::string& content) { return set(content, posed, style); }),
          first);
    paragraph.clear();
    first.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line.starts_with("    ")) {
      end_paragraph();
      page += line + "\n";
    } else if (line.starts_with("- ")) {
      end_paragraph();
      first = "- ";
      paragraph = line.substr(2);
    } else {
      paragraph += (paragraph.empty() ? "" : " ") + trimmed(line);
    }
  }
  end_paragraph();
  return page;
}

std::vector<std::string> complaints_about(const std::string& markdown, const Posed& posed) {
  std::vector<std::string> complaints;
  const std::string text = filled(markdown, posed.values);
  try {
    const std::string rest =
        without_braces(markdown, [&](const std::string&) { return std::string(); });
    if (is_typed_decimal(rest))
      complaints.push_back(
          "a decimal number is typed in the text; write {{expression : digits}} or {name}");
    without_braces(text, [&](const std::string& content) {
      if (const std::string complaint = complaint_about_claim(content, posed); !complaint.empty())
        complaints.push_back(complaint);
      return std::string();
    });
    std::istringstream lines(page_of(markdown, posed, {}));
    for (std::string line; std::getline(lines, line);)
      if (render::columns(line) > render::page_width)
        complaints.push_back("a line is wider than 80 columns: " + line);
  } catch (const std::exception& error) {
    complaints.emplace_back(error.what());
  }
  return complaints;
}

}  // namespace magicmass::command
