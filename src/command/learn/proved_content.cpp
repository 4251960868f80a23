// SPDX-License-Identifier: GPL-2.0-or-later
#include "command/learn/proved_content.hpp"

#include <stdexcept>

#include <ginac/ginac.h>

#include "proof/text.hpp"

namespace magicmass::command {
namespace {

std::string with_notation(std::string text, const Values& notation) {
  for (const auto& [from, to] : notation)
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
      text.replace(at, from.size(), to);
  return text;
}

}  // namespace

std::string ProvedContent::complaint(const Posed& posed, const std::string& solution,
                                     const std::string& theorem) {
  if (!derivation_) derivation_ = std::make_unique<derivation::Derivation>(derivation::derive());
  std::string proved;
  try {
    proved = proof::to_text(derivation_->at(theorem).rhs());
  } catch (const InvalidInput&) {
    return "theorem: there is none called " + theorem + "; magicmass derive --list has them";
  }
  Posed question = posed;  // the theorem is the solution, and ours an answer to it
  question.exercise.misconceptions.clear();
  question.exercise.symbols.clear();
  question.exercise.form.clear();
  if (question.exercise.shape != Shape::matrix) question.exercise.shape = Shape::expression;
  question.solution = with_notation(proved, posed.exercise.notation);
  for (const auto& [name, value] : posed.exercise.where) question.values[name] = value;
  const Judgement judgement = judge_symbolic(question, solution, {});
  if (judgement.verdict == Judged::right) return {};
  return "the solution is not what the theorem " + theorem + " says, " + question.solution + ": " +
         judgement.said + " " + judgement.explanation;
}

}  // namespace magicmass::command
