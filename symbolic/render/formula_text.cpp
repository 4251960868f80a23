// SPDX-License-Identifier: GPL-2.0-or-later
// Formulas on one line.
#include "render/formula_text.hpp"

#include <algorithm>
#include <map>

#include "render/notation.hpp"

namespace magicmass::render {
namespace {

using Kind = Formula::Kind;
using Letters = std::map<std::string, std::string, std::less<>>;

std::string shown(const Formula& formula);

/// The text with each letter replaced, if every letter has a replacement; else nothing.
std::string all_replaced(const std::string& text, const Letters& letters) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t length = 1;
    while (i + length < text.size() && columns(text.substr(i, length + 1)) == 1) ++length;
    const auto letter = letters.find(text.substr(i, length));
    if (letter == letters.end()) return "";
    result += letter->second;
    i += length;
  }
  return result;
}

std::string lowered(const std::string& text) {
  static const Letters letters{{"0", "₀"}, {"1", "₁"}, {"2", "₂"}, {"3", "₃"}, {"4", "₄"},
                               {"5", "₅"}, {"6", "₆"}, {"7", "₇"}, {"8", "₈"}, {"9", "₉"},
                               {"+", "₊"}, {"−", "₋"}, {"(", "₍"}, {")", "₎"}, {"a", "ₐ"},
                               {"e", "ₑ"}, {"i", "ᵢ"}, {"j", "ⱼ"}, {"k", "ₖ"}, {"m", "ₘ"},
                               {"n", "ₙ"}, {"r", "ᵣ"}, {"t", "ₜ"}, {"x", "ₓ"}, {" ", ""}};
  return all_replaced(text, letters);
}

std::string raised(const std::string& text) {
  static const Letters letters{{"0", "⁰"}, {"1", "¹"}, {"2", "²"}, {"3", "³"}, {"4", "⁴"},
                               {"5", "⁵"}, {"6", "⁶"}, {"7", "⁷"}, {"8", "⁸"}, {"9", "⁹"},
                               {"+", "⁺"}, {"−", "⁻"}, {"(", "⁽"}, {")", "⁾"}, {"n", "ⁿ"},
                               {"k", "ᵏ"}, {"j", "ʲ"}, {"m", "ᵐ"}, {"T", "ᵀ"}, {" ", ""}};
  return all_replaced(text, letters);
}

std::string name(std::string_view text) {
  const Symbol symbol = symbol_of(text);
  std::string result = unicode_letter(symbol.base);
  for (std::size_t i = 0; i < symbol.primes; ++i) result += "′";
  if (symbol.subscript.empty()) return result;
  const std::string low = lowered(symbol.subscript);
  return result + (low.empty() ? "_" + unicode_letter(symbol.subscript) : low);
}

std::string parenthesised(const std::string& inside) {
  return inside.find('(') == std::string::npos ? "(" + inside + ")" : "[" + inside + "]";
}

bool is_compound(const Formula& part) {
  return part.kind == Kind::sum || part.kind == Kind::negative || part.kind == Kind::relation;
}

/// ½ and its like; others as they are.
std::string quotient_of_numbers(const std::string& above, const std::string& below) {
  static const Letters halves{{"1/2", "½"}, {"1/3", "⅓"}, {"2/3", "⅔"}, {"1/4", "¼"}, {"3/4", "¾"}};
  const auto half = halves.find(above + "/" + below);
  return half == halves.end() ? above + "/" + below : half->second;
}

std::string factor(const Formula& part) {
  const bool open = is_compound(part) ||
                    (part.kind == Kind::quotient &&
                     !(part.parts[0].kind == Kind::number && part.parts[1].kind == Kind::number));
  return open ? "(" + shown(part) + ")" : shown(part);
}

/// One letter, Greek or not, or a number.
bool is_letter(const Formula& part) {
  return part.kind == Kind::name && columns(name(part.text)) == 1;
}

const char* between(const Formula& left, const Formula& right) {
  if (right.kind == Kind::number ||
      (right.kind == Kind::power && right.parts[0].kind == Kind::number))
    return "·";
  const bool root = right.kind == Kind::call && right.text == "sqrt";
  const Formula& base = right.kind == Kind::power ? right.parts[0] : right;
  const bool function = base.kind == Kind::call && !upright_function(base.text).empty();
  if (left.kind == Kind::number) return function ? " " : "";
  if (is_letter(left)) return is_letter(base) || root ? "" : " ";
  if (left.kind == Kind::sum) return is_letter(right) ? "" : " ";
  return " ";
}

std::string product(const Formula& formula) {
  std::string text;
  for (std::size_t i = 0; i < formula.parts.size(); ++i)
    text +=
        (i == 0 ? "" : between(formula.parts[i - 1], formula.parts[i])) + factor(formula.parts[i]);
  return text;
}

std::string quotient(const Formula& formula) {
  const Formula& above = formula.parts[0];
  const Formula& below = formula.parts[1];
  if (above.kind == Kind::number && below.kind == Kind::number)
    return quotient_of_numbers(above.text, below.text);
  const bool open = below.kind == Kind::product || below.kind == Kind::quotient;
  return factor(above) + "/" + (open ? "(" + shown(below) + ")" : factor(below));
}

std::string power(const Formula& formula) {
  const Formula& base = formula.parts[0];
  const Formula& exponent = formula.parts[1];
  std::string high = raised(shown(exponent));
  if (high.empty())
    high = "^" + (exponent.kind == Kind::number || exponent.kind == Kind::name
                      ? shown(exponent)
                      : "(" + shown(exponent) + ")");
  const bool applied = base.kind == Kind::call && !upright_function(base.text).empty() &&
                       exponent.kind == Kind::number;
  if (applied)
    return upright_function(base.text) + high +
           shown(base).substr(upright_function(base.text).size());
  const bool element = base.kind == Kind::call && !is_function_name(base.text);
  const bool open = base.kind == Kind::product || base.kind == Kind::power ||
                    base.kind == Kind::adjacent || (element && !is_element(base));
  return (open ? "(" + shown(base) + ")" : factor(base)) + high;
}

std::string arguments(const Formula& call) {
  std::string text;
  for (std::size_t i = 0; i < call.parts.size(); ++i) {
    const bool parameters = !call.signs.empty() && call.signs[0] == std::to_string(i);
    text += (i == 0 ? "" : parameters ? "; " : ", ") + shown(call.parts[i]);
  }
  return text;
}

std::string root(const Formula& inside) {
  const bool closed = inside.kind == Kind::number || inside.kind == Kind::name;
  return "√" + (closed ? shown(inside) : "(" + shown(inside) + ")");
}

std::string call(const Formula& formula) {
  const std::vector<Formula>& parts = formula.parts;
  if (is_element(formula)) {
    const std::string low =
        symbol_of(formula.text).subscript.empty() ? lowered(shown(parts[0])) : "";
    return name(formula.text) + (low.empty() ? "(" + shown(parts[0]) + ")" : low);
  }
  if (parts.size() == 1) {
    if (formula.text == "sqrt") return root(parts[0]);
    if (formula.text == "abs") return "|" + shown(parts[0]) + "|";
    if (formula.text == "ceil") return "⌈" + shown(parts[0]) + "⌉";
    if (formula.text == "floor") return "⌊" + shown(parts[0]) + "⌋";
    if (formula.text == "factorial")
      return (parts[0].kind == Kind::name || parts[0].kind == Kind::number
                  ? shown(parts[0])
                  : "(" + shown(parts[0]) + ")") +
             "!";
  }
  if (is_sum_over_index(formula)) {
    const SumParts sum = sum_parts(formula);
    return "Σ[" + shown(sum.index) + " = " + shown(sum.lower) + ", …, " + shown(sum.upper) + "] " +
           factor(sum.term);
  }
  if (formula.text == "lim" && parts.size() == 2)
    return "lim[" + shown(parts[1]) + " → ∞] " + factor(parts[0]);
  const std::string upright = upright_function(formula.text);
  return (upright.empty() ? name(formula.text) : upright) + parenthesised(arguments(formula));
}

std::string matrix(const Formula& formula) {
  std::string text;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    if (i % formula.columns == 0) text += i == 0 ? "[" : "], [";
    text += (i % formula.columns == 0 ? "" : ", ") + shown(formula.parts[i]);
  }
  return "[" + text + "]]";
}

std::string sum(const Formula& formula) {
  std::string text;
  for (const Formula& term : formula.parts) {
    const bool negative = term.kind == Kind::negative;
    if (!text.empty()) text += negative ? " − " : " + ";
    text += text.empty() || !negative    ? shown(term)
            : is_compound(term.parts[0]) ? factor(term.parts[0])
                                         : shown(term.parts[0]);
  }
  return text;
}

std::string relation(const Formula& formula) {
  std::string text = shown(formula.parts[0]);
  for (std::size_t i = 0; i < formula.signs.size(); ++i)
    text += " " + unicode_sign(formula.signs[i]) + " " + shown(formula.parts[i + 1]);
  return text;
}

std::string shown(const Formula& formula) {
  switch (formula.kind) {
    case Kind::name:
      return upright_function(formula.text).empty() ? name(formula.text)
                                                    : upright_function(formula.text);
    case Kind::sum:
      return sum(formula);
    case Kind::negative: {
      const Formula& inside = formula.parts[0];
      return "−" + (is_compound(inside) ? "(" + shown(inside) + ")" : shown(inside));
    }
    case Kind::product:
      return product(formula);
    case Kind::adjacent: {
      std::string text;
      for (const Formula& part : formula.parts)
        text += (text.empty() ? "" : " ") + (is_cross(formula, part)       ? "×"
                                             : part.kind == Kind::adjacent ? "(" + shown(part) + ")"
                                                                           : factor(part));
      return text;
    }
    case Kind::quotient:
      return quotient(formula);
    case Kind::power:
      return power(formula);
    case Kind::call:
      return call(formula);
    case Kind::matrix:
      return matrix(formula);
    case Kind::list:
      return "(" + arguments(formula) + ")";
    case Kind::dot:
      return factor(formula.parts[0]) + "·" + factor(formula.parts[1]);
    case Kind::entry: {
      const std::string low = lowered(formula.text);
      return "(" + shown(formula.parts[0]) + ")" + (low.empty() ? "_" + formula.text : low);
    }
    case Kind::absolute:
      return "|" + shown(formula.parts[0]) + "|";
    case Kind::relation:
      return relation(formula);
    case Kind::number:
    case Kind::verbatim:
      break;
  }
  return formula.text;
}

}  // namespace

std::string inline_text(const Formula& formula, const TextStyle& style) {
  return style.unicode ? shown(formula) : source(formula);
}

}  // namespace magicmass::render
