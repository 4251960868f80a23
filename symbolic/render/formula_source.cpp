// SPDX-License-Identifier: GPL-2.0-or-later
// A formula back as the text it was read from: the notation of proof/text.cpp.
#include "render/formula.hpp"

namespace magicmass::render {
namespace {

using Kind = Formula::Kind;

std::string joined(const std::vector<Formula>& parts, const char* between) {
  std::string text;
  for (const Formula& part : parts) text += (text.empty() ? "" : between) + source(part);
  return text;
}

std::string in_parentheses(const Formula& part) { return "(" + source(part) + ")"; }

std::string factor(const Formula& part) {
  return part.kind == Kind::sum || part.kind == Kind::negative || part.kind == Kind::quotient ||
                 part.kind == Kind::product
             ? in_parentheses(part)
             : source(part);
}

std::string base(const Formula& part) {
  return part.kind == Kind::power || part.kind == Kind::adjacent ? in_parentheses(part)
                                                                 : factor(part);
}

std::string sum(const Formula& formula) {
  std::string text;
  for (const Formula& term : formula.parts) {
    const bool negative = term.kind == Kind::negative;
    if (!text.empty()) text += negative ? " - " : " + ";
    text += text.empty() || !negative ? source(term) : source(term.parts[0]);
  }
  return text;
}

std::string product(const Formula& formula) {
  std::string text;
  for (const Formula& part : formula.parts) text += (text.empty() ? "" : "*") + factor(part);
  return text;
}

std::string adjacent(const Formula& formula) {
  std::string text;
  for (const Formula& part : formula.parts)
    text += (text.empty() ? "" : " ") +
            (part.kind == Kind::adjacent ? in_parentheses(part) : factor(part));
  return text;
}

std::string call(const Formula& formula) {
  std::string inside;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    const bool parameters = !formula.signs.empty() && formula.signs[0] == std::to_string(i);
    inside += (i == 0 ? "" : parameters ? "; " : ", ") + source(formula.parts[i]);
  }
  return formula.text + "(" + inside + ")";
}

std::string matrix_source(const Formula& formula) {
  std::string text;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    if (i % formula.columns == 0) text += i == 0 ? "[" : "], [";
    text += (i % formula.columns == 0 ? "" : ", ") + source(formula.parts[i]);
  }
  return "[" + text + "]]";
}

std::string relation(const Formula& formula) {
  std::string text = source(formula.parts[0]);
  for (std::size_t i = 0; i < formula.signs.size(); ++i)
    text += " " + formula.signs[i] + " " + source(formula.parts[i + 1]);
  return text;
}

}  // namespace

std::string source(const Formula& formula) {
  const std::vector<Formula>& parts = formula.parts;
  switch (formula.kind) {
    case Kind::sum:
      return sum(formula);
    case Kind::negative:
      return "-" + (parts[0].kind == Kind::sum ? in_parentheses(parts[0]) : source(parts[0]));
    case Kind::product:
      return product(formula);
    case Kind::adjacent:
      return adjacent(formula);
    case Kind::quotient:
      return (parts[0].kind == Kind::product ? product(parts[0]) : factor(parts[0])) + "/" +
             factor(parts[1]);
    case Kind::power:
      return base(parts[0]) + "^" + base(parts[1]);
    case Kind::call:
      return call(formula);
    case Kind::matrix:
      return matrix_source(formula);
    case Kind::list:
      return "(" + joined(parts, ", ") + ")";
    case Kind::dot:
      return factor(parts[0]) + formula.text + factor(parts[1]);
    case Kind::entry:
      return in_parentheses(parts[0]) + "_" + formula.text;
    case Kind::absolute:
      return "|" + source(parts[0]) + "|";
    case Kind::relation:
      return relation(formula);
    case Kind::number:
    case Kind::name:
    case Kind::verbatim:
      break;
  }
  return formula.text;
}

}  // namespace magicmass::render
