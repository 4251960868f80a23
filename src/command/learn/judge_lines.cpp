// SPDX-License-Identifier: GPL-2.0-or-later
// Derivations: each line must follow from the one before; the first that does not is named.
#include <sstream>

#include <fmt/format.h>

#include "command/learn/expressions.hpp"
#include "command/learn/judgement.hpp"
#include "equality/form.hpp"

namespace magicmass::command {
namespace {

using equality::Answer;
using equality::Tree;

constexpr std::size_t most_lines = 40;

std::vector<std::string> split(const std::string& text, char separator) {
  std::istringstream stream(text);
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, separator);)
    if (part.find_first_not_of(" \t\r") != std::string::npos) parts.push_back(part);
  return parts;
}

std::vector<std::string> lines_of_answer(const std::string& typed) {
  std::vector<std::string> lines = split(typed, '\n');
  if (lines.size() == 1) lines = split(typed, ';');  // on a command line
  if (lines.empty()) throw NotUnderstood("there is no line in it");
  if (lines.size() > most_lines) throw NotUnderstood("more than 40 lines");
  return lines;
}

Judgement stopped(Judgement judgement, std::size_t line, const equality::Verdict& verdict,
                  const std::string& claim) {
  if (verdict.answer == Answer::undecided) {
    judgement.verdict = Judged::undecided;
    judgement.said = fmt::format("Line {} is undecided: {}.", line, verdict.proof);
    return judgement;
  }
  judgement.verdict = Judged::wrong;
  judgement.said = fmt::format("Line {} is the first that is not right.", line);
  const auto& sides = *verdict.counterexample;
  std::string at;
  for (const auto& [name, value] : sides.point)
    at += (at.empty() ? "at " : ", ") + name + " = " + value;
  judgement.explanation = fmt::format("{}: {} it is {} on one side and {} on the other.", claim, at,
                                      sides.left, sides.right);
  return judgement;
}

/// An expression; an equation as the difference of its sides.
Tree as_one(const std::string& text, const Posed& posed) {
  const std::string place = (posed.exercise.folder / "misconceptions.toml").string();
  const std::vector<std::string> sides = split(text, '=');
  const Tree left = with_values(read_content(sides.front(), place), posed.values);
  if (sides.size() == 1) return left;
  return equality::difference(left, with_values(read_content(sides.back(), place), posed.values));
}

Judgement with_misconception(Judgement judgement, const Posed& posed, const Tree& wrong) {
  if (judgement.verdict != Judged::wrong) return judgement;
  const Tree negative = equality::product({equality::number(-1), wrong});
  const bool is_equation = posed.exercise.shape == Shape::equations;
  for (const Misconception& one : posed.exercise.misconceptions)
    for (const std::string& text : one.answers) {
      const Tree line = as_one(text, posed);
      if (!are_equal(wrong, line, posed.exercise.domain) &&
          !(is_equation && are_equal(negative, line, posed.exercise.domain)))
        continue;
      judgement.misconception = one.name;
      judgement.explanation = one.feedback;
      return judgement;
    }
  return judgement;
}

Judgement judge_chain(const Posed& posed, const std::vector<std::string>& lines,
                      const render::TextStyle& style) {
  const Exercise& exercise = posed.exercise;
  const std::vector<std::string> allowed = posed.allowed_symbols();
  Judgement judgement;
  std::vector<std::pair<std::size_t, Tree>> steps;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string read;
    const std::vector<std::string> parts = split(lines[i], '=');
    if (parts.empty()) throw NotUnderstood(fmt::format("line {} has nothing beside its =", i + 1));
    for (const std::string& part : parts) {
      try {
        steps.emplace_back(i + 1, read_answer(part, allowed));
      } catch (const NotUnderstood& error) {
        throw NotUnderstood(fmt::format("line {}: {}", i + 1, error.what()));
      }
      read += (read.empty() ? "" : " = ") + shown(steps.back().second, style);
    }
    judgement.read_as.push_back(read);
  }
  Tree before = with_values(read_content(exercise.start, "start"), posed.values);
  bool is_first = true;
  for (const auto& [line, step] : steps) {
    const Tree now = with_values(step, posed.values);
    const equality::Verdict verdict = decided(now, before, exercise.domain);
    if (verdict.answer != Answer::equal)
      return with_misconception(
          stopped(judgement, line, verdict,
                  is_first ? "It does not equal what the derivation starts from"
                           : "It does not equal the line before"),
          posed, now);
    before = now;
    is_first = false;
  }
  const std::string lack = equality::what_lacks_form(steps.back().second, exercise.form);
  judgement.verdict = lack.empty() ? Judged::right : Judged::form;
  judgement.said = lack.empty()
                       ? fmt::format("Right: {} lines, each equal to the one before.", lines.size())
                       : fmt::format(
                             "Every line holds, but the last is not the end yet: {}; asked "
                             "for: {}.",
                             lack, exercise.form);
  return judgement;
}

Judgement judge_equations(const Posed& posed, const std::vector<std::string>& lines,
                          const render::TextStyle& style) {
  const Exercise& exercise = posed.exercise;
  const std::vector<std::string> allowed = posed.allowed_symbols();
  Judgement judgement;
  Tree left, right;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::vector<std::string> sides = split(lines[i], '=');
    if (sides.size() != 2)
      throw NotUnderstood(fmt::format("line {} is no equation: one = is expected", i + 1));
    try {
      left = read_answer(sides[0], allowed);
      right = read_answer(sides[1], allowed);
    } catch (const NotUnderstood& error) {
      throw NotUnderstood(fmt::format("line {}: {}", i + 1, error.what()));
    }
    judgement.read_as.push_back(shown(left, style) + " = " + shown(right, style));
    Values all = posed.values;
    all.insert(exercise.truth.begin(), exercise.truth.end());
    const equality::Verdict verdict =
        decided(with_values(left, all), with_values(right, all), exercise.domain);
    if (verdict.answer != Answer::equal)
      return with_misconception(
          stopped(judgement, i + 1, verdict, "It is not true of this motion"), posed,
          equality::difference(with_values(left, posed.values), with_values(right, posed.values)));
  }
  const auto has_unknowns = [&](const Tree& tree) {
    for (const std::string& name : equality::symbols_of(tree))
      if (exercise.truth.contains(name)) return true;
    return false;
  };
  const std::vector<std::string> last = split(split(posed.solution, '\n').back(), '=');
  const Tree target = read_content(last.front(), "solution/answer.txt");
  const bool is_end = equality::identical(left, target) && !has_unknowns(right);
  judgement.verdict = is_end ? Judged::right : Judged::form;
  judgement.said = is_end ? "Right: every line is true, and the last one is the answer."
                          : "Every line is true, but the last is not the end yet; asked for: " +
                                shown(target, style) + " = an expression without unknowns.";
  return judgement;
}

}  // namespace

Judgement judge_lines(const Posed& posed, const std::string& answer,
                      const render::TextStyle& style) {
  const std::vector<std::string> lines = lines_of_answer(answer);
  return posed.exercise.shape == Shape::derivation ? judge_chain(posed, lines, style)
                                                   : judge_equations(posed, lines, style);
}

}  // namespace magicmass::command
