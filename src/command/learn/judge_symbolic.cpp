// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "command/learn/expressions.hpp"
#include "command/learn/judgement.hpp"
#include "equality/form.hpp"
#include "equality/tokens.hpp"
#include "equality/typed_text.hpp"

namespace magicmass::command {
namespace {

using equality::Answer;
using equality::Tree;

/// An expression is a matrix of one entry.
struct Entries {
  std::vector<std::vector<Tree>> rows;

  std::size_t columns() const { return rows.front().size(); }
  bool has_shape_of(const Entries& other) const {
    return rows.size() == other.rows.size() && columns() == other.columns();
  }
};

template <class Reader>
Entries read(const std::string& text, Shape shape, const Reader& reader) {
  Entries entries;
  if (shape == Shape::expression) {
    entries.rows = {{reader(text)}};
    return entries;
  }
  try {
    for (const auto& row : equality::matrix_entries(text)) {
      entries.rows.emplace_back();
      for (const std::string& entry : row) entries.rows.back().push_back(reader(entry));
    }
  } catch (const equality::NotAnExpression& error) {
    throw NotUnderstood(error.what());
  }
  return entries;
}

/// "c_n = ..." and "cos(psi/2) = ..." are answers, too: what is in front goes.
std::string without_name(const std::string& typed) {
  const std::size_t equals = typed.find('=');
  if (equals == std::string::npos || typed.find('=', equals + 1) != std::string::npos ||
      (equals > 0 && std::string("<>!").find(typed[equals - 1]) != std::string::npos))
    return typed;
  constexpr std::size_t longest_name = 24;
  return equals < longest_name ? typed.substr(equals + 1) : typed;
}

Entries mapped(const Entries& entries, const auto& function) {
  Entries result = entries;
  for (auto& row : result.rows)
    for (Tree& entry : row) entry = function(entry);
  return result;
}

struct Difference {
  Answer answer = Answer::equal;
  std::size_t row = 0, column = 0;
  equality::Verdict verdict = {};
};

/// The first entry that is certainly different, else one that is undecided.
Difference compare(const Entries& left, const Entries& right,
                   const std::vector<std::string>& domain) {
  Difference first;
  for (std::size_t i = 0; i < left.rows.size(); ++i)
    for (std::size_t k = 0; k < left.columns(); ++k) {
      equality::Verdict verdict = decided(left.rows[i][k], right.rows[i][k], domain);
      if (verdict.answer == Answer::equal) continue;
      if (verdict.answer == Answer::different) return {Answer::different, i, k, verdict};
      if (first.answer == Answer::equal) first = {Answer::undecided, i, k, verdict};
    }
  return first;
}

const Misconception* recognised(const Posed& posed, const Entries& answer,
                                const Entries& solution) {
  const Exercise& exercise = posed.exercise;
  const auto is_answer = [&](const Entries& wrong) {
    return wrong.has_shape_of(answer) &&
           compare(answer,
                   mapped(wrong, [&](const Tree& t) { return with_values(t, posed.values); }),
                   exercise.domain)
                   .answer == Answer::equal;
  };
  const std::string place = (exercise.folder / "misconceptions.toml").string();
  for (const Misconception& one : exercise.misconceptions) {
    for (const std::string& text : one.answers)
      if (is_answer(read(text, exercise.shape,
                         [&](const std::string& entry) { return read_content(entry, place); })))
        return &one;
    if (!one.replace.empty() && is_answer(mapped(solution, [&](const Tree& tree) {
          return replaced(tree, one.replace, place);
        })))
      return &one;
  }
  return nullptr;
}

std::string shown_entries(const Entries& entries, const render::TextStyle& style) {
  if (entries.rows.size() == 1 && entries.columns() == 1) return shown(entries.rows[0][0], style);
  std::string text;
  for (const auto& row : entries.rows) {
    std::string line;
    for (const Tree& entry : row) line += (line.empty() ? "" : ", ") + shown(entry, style);
    text += (text.empty() ? "[" : ", ") + ("[" + line + "]");
  }
  return text + "]";
}

std::string missing_form(const Entries& answer, const std::string& form) {
  for (const auto& row : answer.rows)
    for (const Tree& entry : row)
      if (const std::string lack = equality::what_lacks_form(entry, form); !lack.empty())
        return lack;
  return {};
}

/// Factors and terms in one order: 4 alpha V is 4 V alpha and no other form of it.
Tree in_order(const Tree& tree) {
  equality::Node node = *tree;
  for (Tree& part : node.parts) part = in_order(part);
  if (node.kind == equality::Kind::sum || node.kind == equality::Kind::product)
    std::sort(node.parts.begin(), node.parts.end(), [](const Tree& left, const Tree& right) {
      return equality::to_text(left) < equality::to_text(right);
    });
  return std::make_shared<const equality::Node>(std::move(node));
}

Judgement right(const Posed& posed, Judgement judgement, const Entries& answer,
                const Entries& solution, const render::TextStyle& style) {
  const std::string& form = posed.exercise.form;
  if (const std::string lack = form.empty() ? "" : missing_form(answer, form); !lack.empty()) {
    judgement.verdict = Judged::form;
    judgement.said = fmt::format("Equal to the answer, but {}; asked for: {}.", lack, form);
    return judgement;
  }
  judgement.verdict = Judged::right;
  const std::string ours = shown_entries(solution, style);
  const render::TextStyle plain;
  judgement.said = shown_entries(mapped(solution, in_order), plain) ==
                           shown_entries(mapped(answer, in_order), plain)
                       ? "Right."
                       : "Right, in another form than ours, which is " + ours + ".";
  return judgement;
}

Entries read_typed(const Posed& posed, const std::string& typed,
                   const std::vector<std::string>& allowed) {
  const Shape shape = posed.exercise.shape;
  return read(shape == Shape::expression ? without_name(typed) : typed, shape,
              [&](const std::string& text) { return read_answer(text, allowed); });
}

/// An answer with names that are not asked for, such as theta where psi is meant: the misconception that has them.
std::optional<Judgement> mistaken_names(const Posed& posed, const std::string& typed,
                                        const Entries& solution, const render::TextStyle& style) {
  std::vector<std::string> allowed = posed.allowed_symbols();
  const std::string place = (posed.exercise.folder / "misconceptions.toml").string();
  for (const Misconception& one : posed.exercise.misconceptions)
    for (const std::string& text : one.answers)
      for (const auto& row : read(text, posed.exercise.shape, [&](const std::string& entry) {
                               return read_content(entry, place);
                             }).rows)
        for (const Tree& entry : row)
          for (const std::string& name : equality::symbols_of(entry)) allowed.push_back(name);
  try {
    const Entries answer = read_typed(posed, typed, allowed);
    const Misconception* one = recognised(
        posed, mapped(answer, [&](const Tree& t) { return with_values(t, posed.values); }),
        solution);
    if (one == nullptr) return std::nullopt;
    return Judgement{.verdict = Judged::wrong,
                     .read_as = {shown_entries(answer, style)},
                     .said = "Not right.",
                     .misconception = one->name,
                     .explanation = one->feedback};
  } catch (const NotUnderstood&) {
    return std::nullopt;
  }
}

}  // namespace

std::string replaced_solution(const Posed& posed, const Misconception& misconception) {
  const Exercise& exercise = posed.exercise;
  const Entries solution = read(posed.solution, exercise.shape, [](const std::string& text) {
    return read_content(text, "solution");
  });
  std::string text;
  for (const auto& row : solution.rows) {
    std::string line;
    for (const Tree& entry : row)
      line += (line.empty() ? "" : ", ") +
              equality::to_text(replaced(entry, misconception.replace, "misconceptions.toml"));
    text += (text.empty() ? "[" : ", [") + line + "]";
  }
  return exercise.shape == Shape::matrix ? "[" + text + "]" : text.substr(1, text.size() - 2);
}

Judgement judge_symbolic(const Posed& posed, const std::string& typed,
                         const render::TextStyle& style) {
  const Exercise& exercise = posed.exercise;
  const std::string place = (exercise.folder / "solution/answer.txt").string();
  const Entries solution = read(posed.solution, exercise.shape,
                                [&](const std::string& text) { return read_content(text, place); });
  Entries answer;
  try {
    answer = read_typed(posed, typed, posed.allowed_symbols());
  } catch (const NotUnderstood&) {
    if (const auto mistaken = mistaken_names(posed, typed, solution, style)) return *mistaken;
    throw;
  }
  Judgement judgement;
  judgement.read_as = {shown_entries(answer, style)};
  if (!answer.has_shape_of(solution)) {
    judgement.verdict = Judged::wrong;
    judgement.said = "Not right.";
    judgement.explanation =
        fmt::format("Yours has {} rows and {} columns; the matrix asked for has {} and {}.",
                    answer.rows.size(), answer.columns(), solution.rows.size(), solution.columns());
    return judgement;
  }
  const auto in_full = [&](const Tree& tree) { return with_values(tree, posed.values); };
  const Entries given = mapped(answer, in_full);
  const Entries expected = mapped(solution, in_full);
  const Difference difference = compare(given, expected, exercise.domain);
  if (difference.answer == Answer::equal) return right(posed, judgement, answer, solution, style);
  if (difference.answer == Answer::undecided) {
    judgement.said = "Undecided: " + difference.verdict.proof +
                     ". This is not a verdict on your answer; try to write it in a simpler form.";
    return judgement;
  }
  judgement.verdict = Judged::wrong;
  judgement.said = "Not right.";
  if (const Misconception* one = recognised(posed, given, solution)) {
    judgement.misconception = one->name;
    judgement.explanation = one->feedback;
    return judgement;
  }
  const Entries negative = mapped(expected, [](const Tree& tree) {
    return equality::product({equality::number(-1), tree});
  });
  const bool is_negative = compare(given, negative, exercise.domain).answer == Answer::equal;
  std::string where =
      exercise.shape == Shape::matrix
          ? fmt::format("Row {}, column {}: ", difference.row + 1, difference.column + 1)
          : "";
  judgement.explanation = is_negative
                              ? "Only the sign is wrong: yours is minus the answer."
                              : capitalised(where + shown(*difference.verdict.counterexample));
  return judgement;
}

}  // namespace magicmass::command
