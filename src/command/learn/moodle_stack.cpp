// SPDX-License-Identifier: GPL-2.0-or-later
#include <cctype>

#include <fmt/format.h>

#include "command/learn/expressions.hpp"
#include "command/learn/moodle.hpp"
#include "equality/paper_names.hpp"
#include "equality/typed_text.hpp"

namespace magicmass::command {
namespace {

using equality::Kind;
using equality::Tree;

Tree without_roots(const Tree& tree) {
  std::vector<Tree> parts;
  parts.reserve(tree->parts.size());
  for (const Tree& part : tree->parts) parts.push_back(without_roots(part));
  if (tree->kind == Kind::root && tree->value != 2)
    return equality::power(parts[0], equality::number(1 / tree->value));
  return parts.empty() ? tree : equality::with_parts(tree, std::move(parts));
}

/// The expression or matrix in Maxima's notation.
std::string maxima_answer(const std::string& text, const Posed& posed) {
  const auto entry = [&](const std::string& one) {
    return maxima(with_values(read_content(one, posed.exercise.id), posed.values));
  };
  if (posed.exercise.shape != Shape::matrix) return entry(text.substr(text.rfind('=') + 1));
  std::string rows;
  for (const auto& row : equality::matrix_entries(text)) {
    std::string line;
    for (const std::string& one : row) line += (line.empty() ? "" : ",") + entry(one);
    rows += (rows.empty() ? "[" : ",[") + line + "]";
  }
  return "matrix(" + rows + ")";
}

std::string branch(const std::string& side, const std::string& score, long next,
                   const std::string& note, const std::string& feedback) {
  return element(side + "scoremode", "=") + element(side + "score", score) +
         element(side + "penalty", "") + element(side + "nextnode", std::to_string(next)) +
         element(side + "answernote", note) + html_element(side + "feedback", feedback);
}

/// Node 0 asks whether it is right, the others which misconception it is.
std::string node(long index, const std::string& compared_with, long next,
                 const std::string& feedback) {
  const std::string note = fmt::format("prt1-{}", index + 1);
  return "<node>\n" + element("name", std::to_string(index)) + element("answertest", "AlgEquiv") +
         element("sans", "sa1") + element("tans", compared_with) + element("testoptions", "") +
         element("quiet", "1") + branch("true", index == 0 ? "1" : "0", -1, note + "-T", feedback) +
         branch("false", "0", next, note + "-F", "") + "</node>\n";
}

/// The student's answer with the names that the paper defines written out, as they are in ours.
std::string typed_answer(const Posed& posed) {
  std::string equations;
  for (const std::string& name : posed.exercise.symbols)
    if (const auto meaning = equality::meaning(name))
      equations += (equations.empty() ? "" : ",") + name + "=" + maxima(*meaning);
  return equations.empty() ? "sa1:ans1;" : "sa1:subst([" + equations + "],ans1);";
}

std::string input(const Posed& posed) {
  return "<input>\n" + element("name", "ans1") +
         element("type", posed.exercise.shape == Shape::matrix ? "matrix" : "algebraic") +
         element("tans", "ta") + element("boxsize", "40") + element("strictsyntax", "1") +
         element("insertstars", "1") + element("syntaxhint", "") + element("syntaxattribute", "0") +
         element("forbidwords", "") + element("allowwords", "") + element("forbidfloat", "1") +
         element("requirelowestterms", "0") + element("checkanswertype", "1") +
         element("mustverify", "1") + element("showvalidation", "1") + element("options", "") +
         "</input>\n";
}

}  // namespace

std::string maxima(const Tree& tree) {
  const std::string text =
      equality::to_text(equality::substituted(without_roots(tree), "e", equality::symbol("e_r")));
  std::string result;
  std::string word;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char c = i < text.size() ? text[i] : '\0';
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
      continue;
    }
    result += word == "pi" ? "%pi" : word;
    word.clear();
    if (c != '\0') result += c;
  }
  return result;
}

std::string moodle_symbolic(const Posed& posed) {
  const std::string solution = posed.solution.substr(posed.solution.rfind('\n') + 1);
  std::vector<std::pair<std::string, std::string>> wrong;
  const bool is_one_answer =
      posed.exercise.shape == Shape::expression || posed.exercise.shape == Shape::matrix;
  for (const Misconception& one : posed.exercise.misconceptions) {
    if (!is_one_answer) break;  // they are about single lines
    for (const std::string& answer : one.answers)
      wrong.emplace_back(maxima_answer(answer, posed), one.feedback);
    if (!one.replace.empty() && posed.exercise.shape == Shape::expression)
      wrong.emplace_back(maxima(with_values(replaced(read_content(solution, posed.exercise.id),
                                                     one.replace, posed.exercise.id),
                                            posed.values)),
                         one.feedback);
  }
  const std::string answer =
      maxima_answer(posed.exercise.shape == Shape::matrix ? posed.solution : solution, posed);
  std::string xml =
      text_element("stackversion", "") + text_element("questionvariables", "ta:" + answer + ";") +
      html_element("specificfeedback", "[[feedback:prt1]]") +
      text_element("questionnote", "{@ta@}") + element("questionsimplify", "1") +
      element("assumepositive", "1") + element("assumereal", "1") +
      html_element("prtcorrect", "Right.") + html_element("prtpartiallycorrect", "Partly right.") +
      html_element("prtincorrect", "Not right.") + element("multiplicationsign", "dot") +
      element("sqrtsign", "1") + element("complexno", "i") + element("inversetrig", "acos") +
      element("matrixparens", "[") + element("variantsselectionseed", "") + input(posed) +
      "<prt>\n" + element("name", "prt1") + element("value", "1") + element("autosimplify", "1") +
      element("feedbackstyle", "1") + text_element("feedbackvariables", typed_answer(posed));
  const auto count = static_cast<long>(wrong.size());
  xml += node(0, "ta", count > 0 ? 1 : -1, "");
  for (long i = 0; i < count; ++i) {
    const auto& [compared_with, feedback] = wrong[static_cast<std::size_t>(i)];
    xml += node(i + 1, compared_with, i + 1 < count ? i + 2 : -1, feedback);
  }
  return xml + "</prt>\n";
}

}  // namespace magicmass::command
