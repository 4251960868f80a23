// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/formula_mathml.hpp"

#include <algorithm>

#include "render/breaking.hpp"
#include "render/formula_latex.hpp"
#include "render/notation.hpp"

namespace magicmass::render {
namespace {

using Kind = Formula::Kind;

/// `small`: in an argument, an index or within a fraction, where quotients stay on the line.
std::string set(const Formula& formula, bool small);

std::string row(const std::string& inside) { return "<mrow>" + inside + "</mrow>"; }
std::string identifier(const std::string& text) { return "<mi>" + html_escaped(text) + "</mi>"; }
std::string sign(const std::string& text) { return "<mo>" + html_escaped(text) + "</mo>"; }
/// A bracket that needs not be tall is not stretched: browsers leave space beside one that is.
std::string fence(const std::string& text, bool tall) {
  return std::string("<mo fence=\"true\" lspace=\"0\" rspace=\"0\"") +
         (tall ? "" : " stretchy=\"false\"") + ">" + text + "</mo>";
}
const char* const apply = "<mo>&#x2061;</mo>";
const char* const times = "<mo>&#x2062;</mo>";
const char* const strut = "<mspace width=\"0\" height=\"0.75em\" depth=\"0.15em\"/>";  // of a root
const char* const thin_space = "<mspace width=\"0.17em\"/>";

std::string fenced(const std::string& inside, const std::string& left, const std::string& right) {
  const bool tall = inside.find("<mfrac") != std::string::npos ||
                    inside.find("<mtable") != std::string::npos ||
                    inside.find("<munder") != std::string::npos;
  return row(fence(left, tall) + inside + fence(right, tall));
}

std::string letters(const std::string& name) {
  const std::string shown = unicode_letter(name);
  // capital Greek letters and words stand upright, as in LaTeX
  const bool upright = shown != name && name.front() >= 'A' && name.front() <= 'Z';
  if (shown == name && name.size() > 1) return "<mi>" + html_escaped(name) + "</mi>";
  return upright ? "<mi mathvariant=\"normal\">" + shown + "</mi>" : identifier(shown);
}

std::string name(std::string_view text, const std::string& index = "") {
  const Symbol symbol = symbol_of(text);
  std::string low = symbol.subscript.empty() ? "" : letters(symbol.subscript);
  if (!index.empty()) {
    const bool of_point = symbol.subscript == "P" || symbol.subscript == "Q";
    if (of_point)
      low = "<msub>" + low + row(index) + "</msub>";
    else
      low += (low.empty() ? "" : sign(",")) + index;
  }
  std::string primes;
  for (std::size_t i = 0; i < symbol.primes; ++i) primes += "′";
  const std::string base = letters(symbol.base);
  if (primes.empty() && low.empty()) return base;
  if (primes.empty()) return "<msub>" + base + row(low) + "</msub>";
  if (low.empty()) return "<msup>" + base + sign(primes) + "</msup>";
  return "<msubsup>" + base + row(low) + sign(primes) + "</msubsup>";
}

bool is_atom(const Formula& part) {
  return part.kind == Kind::number || part.kind == Kind::name || is_element(part);
}

bool is_compound(const Formula& part) {
  return part.kind == Kind::sum || part.kind == Kind::negative || part.kind == Kind::relation;
}

std::string parenthesised(const Formula& part, bool small) {
  return fenced(set(part, small), "(", ")");
}

std::string factor(const Formula& part, bool small) {
  const bool open = is_compound(part) || (small && part.kind == Kind::quotient);
  return open ? parenthesised(part, small) : set(part, small);
}

bool is_root(const Formula& part) { return part.kind == Kind::call && part.text == "sqrt"; }

bool is_applied(const Formula& part) {
  const Formula& base = part.kind == Kind::power ? part.parts[0] : part;
  return base.kind == Kind::call && !upright_function(base.text).empty();
}

std::string product(const Formula& formula, bool small) {
  std::string result;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    const Formula& part = formula.parts[i];
    const Formula& head = part.kind == Kind::power ? part.parts[0] : part;
    if (i > 0) result += head.kind == Kind::number ? sign("·") : times;
    if (i > 0 && (is_applied(part) || is_applied(formula.parts[i - 1]))) result += thin_space;
    result += factor(part, small);
  }
  return row(result);
}

std::string quotient(const Formula& formula, bool small) {
  const Formula& above = formula.parts[0];
  const Formula& below = formula.parts[1];
  if (!small) return "<mfrac>" + row(set(above, true)) + row(set(below, true)) + "</mfrac>";
  const bool open = below.kind == Kind::product || below.kind == Kind::quotient;
  return row(factor(above, true) + "<mo lspace=\"0\" rspace=\"0\">/</mo>" +
             (open ? parenthesised(below, true) : factor(below, true)));
}

std::string call(const Formula& formula, bool small, const std::string& exponent);

std::string power(const Formula& formula, bool small) {
  const Formula& base = formula.parts[0];
  const std::string high = row(set(formula.parts[1], true));
  // cos^n x, for cos x^n would be the cosine of x^n
  if (is_applied(base)) return call(base, small, high);
  if (is_root(base) && formula.parts[1].kind == Kind::number)  // sqrt(x)^3
    return "<msup>" + factor(base.parts[0], true) +
           row(set(formula.parts[1], true) + "<mo>/</mo><mn>2</mn>") + "</msup>";
  const bool open = base.kind == Kind::product || base.kind == Kind::power ||
                    base.kind == Kind::adjacent || base.kind == Kind::quotient ||
                    (base.kind == Kind::call && base.text == "factorial");
  return "<msup>" + row(open ? parenthesised(base, small) : factor(base, small)) + high + "</msup>";
}

std::string arguments(const Formula& formula) {
  std::string result;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    const bool parameters = !formula.signs.empty() && formula.signs[0] == std::to_string(i);
    result += (i == 0 ? "" : sign(parameters ? ";" : ",")) + set(formula.parts[i], true);
  }
  return result;
}

std::string call(const Formula& formula, bool small, const std::string& exponent) {
  const std::vector<Formula>& parts = formula.parts;
  if (is_element(formula)) return name(formula.text, set(parts[0], true));
  if (parts.size() == 1) {
    if (formula.text == "sqrt") return "<msqrt>" + set(parts[0], small) + strut + "</msqrt>";
    if (formula.text == "abs") return fenced(set(parts[0], small), "|", "|");
    if (formula.text == "ceil") return fenced(set(parts[0], small), "⌈", "⌉");
    if (formula.text == "floor") return fenced(set(parts[0], small), "⌊", "⌋");
    if (formula.text == "factorial")
      return row((is_atom(parts[0]) ? set(parts[0], true) : parenthesised(parts[0], true)) +
                 sign("!"));
  }
  if (formula.text == "binomial" && parts.size() == 2)
    return fenced("<mfrac linethickness=\"0\">" + row(set(parts[0], true)) +
                      row(set(parts[1], true)) + "</mfrac>",
                  "(", ")");
  if (is_sum_over_index(formula)) {
    const SumParts sum = sum_parts(formula);
    return row("<munderover><mo>∑</mo>" +
               row(set(sum.index, true) + sign("=") + set(sum.lower, true)) +
               row(set(sum.upper, true)) + "</munderover>" + factor(sum.term, small));
  }
  if (formula.text == "lim" && parts.size() == 2)
    return row("<munder><mo>lim</mo>" + row(set(parts[1], true) + sign("→") + sign("∞")) +
               "</munder>" + factor(parts[0], small));
  const std::string upright = upright_function(formula.text);
  std::string head = upright.empty() ? name(formula.text) : identifier(upright);
  if (!exponent.empty()) head = "<msup>" + head + exponent + "</msup>";
  const std::string inside = arguments(formula);
  if (parts.size() == 1 && is_atom(parts[0]) && !upright.empty())
    return row(head + apply + thin_space + inside);
  const bool nested = inside.find(">(<") != std::string::npos && !is_root(parts[0]);
  return row(head + apply + fenced(inside, nested ? "[" : "(", nested ? "]" : ")"));
}

std::string matrix(const Formula& formula) {
  std::string result = "<mtable displaystyle=\"true\"><mtr>";
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    if (i > 0 && i % formula.columns == 0) result += "</mtr><mtr>";
    result += "<mtd>" + set(formula.parts[i], false) + "</mtd>";
  }
  return fenced(result + "</mtr></mtable>", "(", ")");
}

std::string sum(const Formula& formula, bool small) {
  std::string result;
  for (const Formula& term : formula.parts) {
    const bool negative = term.kind == Kind::negative && !result.empty();
    if (!result.empty()) result += sign(negative ? "−" : "+");
    result += negative ? (term.parts[0].kind == Kind::sum ? factor(term.parts[0], small)
                                                          : set(term.parts[0], small))
                       : set(term, small);
  }
  return row(result);
}

std::string set(const Formula& formula, bool small) {
  switch (formula.kind) {
    case Kind::number:
      return "<mn>" + html_escaped(formula.text) + "</mn>";
    case Kind::name: {
      const std::string upright = upright_function(formula.text);
      return upright.empty() ? name(formula.text) : identifier(upright);
    }
    case Kind::sum:
      return sum(formula, small);
    case Kind::negative:
      return row("<mo form=\"prefix\">−</mo>" + (is_compound(formula.parts[0])
                                                     ? factor(formula.parts[0], small)
                                                     : set(formula.parts[0], small)));
    case Kind::product:
      return product(formula, small);
    case Kind::adjacent: {
      std::string result;
      for (const Formula& part : formula.parts)
        result += (result.empty() ? "" : thin_space) + (is_cross(formula, part) ? sign("×")
                                                        : part.kind == Kind::adjacent
                                                            ? parenthesised(part, small)
                                                            : factor(part, small));
      return row(result);
    }
    case Kind::quotient:
      return quotient(formula, small);
    case Kind::power:
      return power(formula, small);
    case Kind::call:
      return call(formula, small, "");
    case Kind::matrix:
      return matrix(formula);
    case Kind::list:
      return fenced(arguments(formula), "(", ")");
    case Kind::dot:
      return row(factor(formula.parts[0], small) + sign("·") + factor(formula.parts[1], small));
    case Kind::entry:
      return "<msub>" + parenthesised(formula.parts[0], small) + "<mn>" +
             html_escaped(formula.text) + "</mn></msub>";
    case Kind::absolute:
      return fenced(set(formula.parts[0], small), "|", "|");
    case Kind::relation: {
      std::string result = set(formula.parts[0], small);
      for (std::size_t i = 0; i < formula.signs.size(); ++i)
        result += sign(unicode_sign(formula.signs[i])) + set(formula.parts[i + 1], small);
      return row(result);
    }
    case Kind::verbatim:
      break;
  }
  return "<mtext>" + html_escaped(formula.text) + "</mtext>";
}

std::string mathml_signs(const std::string& text) {
  if (text.ends_with(" -"))
    return mathml_signs(text.substr(0, text.size() - 2)) + "<mo form=\"prefix\">−</mo>";
  if (text.empty()) return "";
  return "<mo form=\"infix\" lspace=\"0\" rspace=\"0.28em\">" +
         html_escaped(text == "-" ? "−" : unicode_sign(text)) + "</mo>";
}

}  // namespace

std::string mathml(const Formula& formula) { return "<math>" + set(formula, true) + "</math>"; }

std::string mathml_display(const Formula& equation) {
  constexpr double phone = 16;  // em: what a page 400 pixels wide has room for
  const bool breaks = latex_width(equation) > phone;
  std::string result;
  for (const Piece& piece : pieces(equation, latex_width, breaks ? phone : 1e9)) {
    std::string inside = mathml_signs(piece.sign);
    for (int i = 0; i < piece.opens; ++i) inside += fence("(", true);
    inside += piece.factor || piece.sign.ends_with('-') ? factor(piece.formula, false)
                                                        : set(piece.formula, false);
    for (int i = 0; i < piece.closes; ++i) inside += fence(")", true);
    result +=
        (result.empty() ? "" : " ") + ("<math displaystyle=\"true\">" + row(inside) + "</math>");
  }
  return result;
}

std::string html_escaped(std::string_view text) {
  std::string result;
  for (const char character : text) {
    switch (character) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(character) >= 0x20 || character == '\n' || character == '\t')
          result += character;
    }
  }
  return result;
}

}  // namespace magicmass::render
