// SPDX-License-Identifier: GPL-2.0-or-later
// Names, elements of sequences and functions.
#include "render/latex_set.hpp"
#include "render/notation.hpp"

namespace magicmass::render::tex {
namespace {

using Kind = Formula::Kind;

constexpr double letter_width = 0.58;
constexpr double script_width = 0.42;

Set named_call(const Formula& formula, const std::string& exponent) {
  const std::string upright = upright_function(formula.text);
  Set result = upright.empty() ? name(formula.text) : Set{};
  if (!upright.empty()) {
    static constexpr std::string_view known =
        " cos sin tan cot sec csc cosh sinh tanh arccos arcsin arctan ln exp det max min gcd lim ";
    result.code = known.find(" " + upright + " ") != std::string_view::npos ? "\\" + upright
                  : upright == "sawtooth"                                   ? "\\mathfrak{s}"
                                          : "\\operatorname{" + upright + "}";
    result.width = 0.5 * static_cast<double>(upright.size());
  }
  result.code += exponent;
  const Set inside = arguments(formula);
  const bool nested = inside.code.find('(') != std::string::npos && !is_root(formula.parts[0]);
  if (formula.parts.size() == 1 && is_atom(formula.parts[0]) && !upright.empty() &&
      upright != "sawtooth") {
    result += inside;
    result.width += 0.17;
    return result;
  }
  const Set closed = fenced(inside, nested ? "[" : "(", nested ? "]" : ")");
  return {result.code + closed.code, result.width + closed.width, closed.tall};
}

}  // namespace

Set fenced(const Set& inside, const std::string& left, const std::string& right) {
  const std::string code = inside.tall ? "\\left" + left + " " + inside.code + " \\right" + right
                                       : left + (left.size() > 1 ? " " : "") + inside.code +
                                             (right.size() > 1 ? " " : "") + right;
  return {code, inside.width + 0.8, inside.tall};
}

Set name(std::string_view text, const Set& index) {
  const Symbol symbol = symbol_of(text);
  Set result{latex_letter(symbol.base) + std::string(symbol.primes, '\''),
             letter_width * (latex_letter(symbol.base).starts_with("\\mathrm")
                                 ? static_cast<double>(symbol.base.size())
                                 : 1.0)};
  result.width += 0.25 * static_cast<double>(symbol.primes);
  std::string low = symbol.subscript.empty() ? "" : latex_letter(symbol.subscript);
  double width =
      symbol.subscript.empty() ? 0 : script_width * static_cast<double>(symbol.subscript.size());
  if (!index.code.empty()) {
    // t_P(n) is the time of P_n
    const bool of_point = symbol.subscript == "P" || symbol.subscript == "Q";
    low += low.empty() ? index.code : of_point ? "_{" + index.code + "}" : "," + index.code;
    width += index.width * 0.75;
  }
  if (!low.empty()) result.code += "_{" + low + "}";
  result.width += width;
  return result;
}

bool is_atom(const Formula& part) {
  return part.kind == Kind::number || part.kind == Kind::name || is_element(part);
}

bool is_root(const Formula& part) { return part.kind == Kind::call && part.text == "sqrt"; }

Set arguments(const Formula& formula) {
  Set result;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    const bool parameters = !formula.signs.empty() && formula.signs[0] == std::to_string(i);
    if (i > 0) result.code += parameters ? ";" : ",";
    result += set(formula.parts[i], true);
  }
  return result;
}

Set call(const Formula& formula, bool small, const std::string& exponent) {
  const std::vector<Formula>& parts = formula.parts;
  if (is_element(formula)) return name(formula.text, set(parts[0], true));
  if (parts.size() == 1) {
    if (formula.text == "sqrt") {
      const Set inside = set(parts[0], small);
      return {"\\sqrt{" + inside.code + "}", inside.width + 0.9, inside.tall};
    }
    if (formula.text == "abs") return fenced(set(parts[0], small), "|", "|");
    if (formula.text == "ceil") return fenced(set(parts[0], small), "\\lceil", "\\rceil");
    if (formula.text == "floor") return fenced(set(parts[0], small), "\\lfloor", "\\rfloor");
    if (formula.text == "O") {
      const Set inside = fenced(set(parts[0], true), "(", ")");
      return {"\\mathcal{O}" + inside.code, inside.width + 0.8, inside.tall};
    }
    if (formula.text == "factorial") {
      Set inside = is_atom(parts[0]) ? set(parts[0], true) : fenced(set(parts[0], true), "(", ")");
      inside.code += "!";
      return inside;
    }
  }
  if (formula.text == "binomial" && parts.size() == 2)
    return {"\\binom{" + set(parts[0], true).code + "}{" + set(parts[1], true).code + "}", 1.5,
            true};
  if (is_sum_over_index(formula)) {
    const SumParts sum = sum_parts(formula);
    Set result{"\\sum_{" + set(sum.index, true).code + "=" + set(sum.lower, true).code + "}^{" +
                   set(sum.upper, true).code + "}",
               1.8, true};
    result += factor(sum.term, small);
    return result;
  }
  if (formula.text == "lim" && parts.size() == 2) {
    Set result{"\\lim_{" + set(parts[1], true).code + " \\to \\infty}", 2.5};
    result += factor(parts[0], small);
    return result;
  }
  return named_call(formula, exponent);
}

}  // namespace magicmass::render::tex
