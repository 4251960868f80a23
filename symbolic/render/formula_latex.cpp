// SPDX-License-Identifier: GPL-2.0-or-later
#include "render/formula_latex.hpp"

#include <algorithm>
#include <map>

#include "render/breaking.hpp"
#include "render/notation.hpp"

namespace magicmass::render {
namespace {

using Kind = Formula::Kind;

/// What is set, about how wide it is in em, and whether parentheses around it must grow.
struct Set {
  std::string code;
  double width = 0;
  bool tall = false;

  Set& operator+=(const Set& next) {
    const bool apart = !code.empty() && !next.code.empty() && code.back() != ' ';
    code += (apart ? " " : "") + next.code;
    width += next.width;
    tall = tall || next.tall;
    return *this;
  }
};

constexpr double letter_width = 0.58;
constexpr double script_width = 0.42;
constexpr double relation_width = 1.4;
const Set thin_space{"\\thinspace", 0.17};

/// `small`: in an argument, an index or within a fraction, where quotients stay on the line.
Set set(const Formula& formula, bool small);

Set braced(const Set& inside) { return {"{" + inside.code + "}", inside.width, inside.tall}; }

Set fenced(const Set& inside, const std::string& left, const std::string& right) {
  const std::string code = inside.tall ? "\\left" + left + " " + inside.code + " \\right" + right
                                       : left + (left.size() > 1 ? " " : "") + inside.code +
                                             (right.size() > 1 ? " " : "") + right;
  return {code, inside.width + 0.8, inside.tall};
}

Set name(std::string_view text, const Set& index = {}) {
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

bool is_compound(const Formula& part) {
  return part.kind == Kind::sum || part.kind == Kind::negative || part.kind == Kind::relation;
}

bool of_numbers(const Formula& quotient) {
  return quotient.parts[0].kind == Kind::number && quotient.parts[1].kind == Kind::number;
}

Set factor(const Formula& part, bool small) {
  const bool open =
      is_compound(part) || (small && part.kind == Kind::quotient && !of_numbers(part));
  return open ? fenced(set(part, small), "(", ")") : set(part, small);
}

bool is_applied(const Formula& part) {
  const Formula& base = part.kind == Kind::power ? part.parts[0] : part;
  return base.kind == Kind::call && !upright_function(base.text).empty();
}

Set product(const Formula& formula, bool small) {
  Set result;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    const Formula& part = formula.parts[i];
    const Formula& head = part.kind == Kind::power ? part.parts[0] : part;
    if (i > 0 && head.kind == Kind::number) result += {"\\cdot", 0.7};
    if (i > 0 && (is_applied(formula.parts[i - 1]) || is_applied(part)) &&
        head.kind != Kind::number)
      result += thin_space;
    result += factor(part, small);
  }
  return result;
}

Set quotient(const Formula& formula, bool small) {
  const Formula& above = formula.parts[0];
  const Formula& below = formula.parts[1];
  if (small && of_numbers(formula)) return {"\\tfrac{" + above.text + "}{" + below.text + "}", 0.5};
  if (small) {
    const bool open = below.kind == Kind::product || below.kind == Kind::quotient;
    Set result = factor(above, true);
    result += {"/", 0.5};
    result += open ? fenced(set(below, true), "(", ")") : factor(below, true);
    return result;
  }
  const Set up = set(above, true);
  const Set down = set(below, true);
  return {"\\frac{" + up.code + "}{" + down.code + "}", std::max(up.width, down.width) + 0.25,
          true};
}

Set call(const Formula& formula, bool small, const std::string& exponent);

Set power(const Formula& formula, bool small) {
  const Formula& base = formula.parts[0];
  const Set high = set(formula.parts[1], true);
  if (is_applied(base) && formula.parts[1].kind == Kind::number)
    return call(base, small, "^{" + high.code + "}");
  const bool open = base.kind == Kind::product || base.kind == Kind::power ||
                    base.kind == Kind::adjacent || (base.kind == Kind::quotient) ||
                    (base.kind == Kind::call && base.text == "factorial");
  Set result = open ? fenced(set(base, small), "(", ")") : factor(base, small);
  if (result.code.ends_with('}') && is_element(base)) result = braced(result);
  result.code += "^{" + high.code + "}";
  result.width += 0.75 * high.width;
  return result;
}

Set arguments(const Formula& formula) {
  Set result;
  for (const Formula& part : formula.parts) {
    if (!result.code.empty()) result.code += ",";
    result += set(part, true);
  }
  return result;
}

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
  const bool nested = inside.code.find('(') != std::string::npos;
  if (formula.parts.size() == 1 && is_atom(formula.parts[0]) && !upright.empty() &&
      upright != "sawtooth") {
    result += inside;
    result.width += 0.17;
    return result;
  }
  const Set closed = fenced(inside, nested ? "[" : "(", nested ? "]" : ")");
  return {result.code + closed.code, result.width + closed.width, closed.tall};
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
  if (formula.text == "sum" && parts.size() == 4) {
    Set result{"\\sum_{" + set(parts[0], true).code + "=" + set(parts[1], true).code + "}^{" +
                   set(parts[2], true).code + "}",
               1.8, true};
    result += factor(parts[3], small);
    return result;
  }
  return named_call(formula, exponent);
}

Set matrix(const Formula& formula) {
  std::vector<double> widths(formula.columns, 0);
  std::string code = "\\begin{pmatrix}";
  bool tall = false;
  for (const Formula& part : formula.parts) tall = tall || set(part, false).tall;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    const Set cell = set(formula.parts[i], false);
    double& width = widths[i % formula.columns];
    width = std::max(width, cell.tall ? 0.8 * cell.width : cell.width);
    if (i > 0) code += i % formula.columns != 0 ? " &" : tall ? " \\\\[1ex]" : " \\\\";
    code += " " + cell.code;
  }
  double width = 1;
  for (const double column : widths) width += column + 1;
  return {code + " \\end{pmatrix}", width, true};
}

Set sum(const Formula& formula, bool small) {
  Set result;
  for (const Formula& term : formula.parts) {
    const bool negative = term.kind == Kind::negative && !result.code.empty();
    if (!result.code.empty()) result += {negative ? "-" : "+", 1.2};
    result += negative ? (term.parts[0].kind == Kind::sum ? factor(term.parts[0], small)
                                                          : set(term.parts[0], small))
                       : set(term, small);
  }
  return result;
}

Set relation(const Formula& formula, bool small) {
  Set result = set(formula.parts[0], small);
  for (std::size_t i = 0; i < formula.signs.size(); ++i) {
    result += {latex_sign(formula.signs[i]), relation_width};
    result += set(formula.parts[i + 1], small);
  }
  return result;
}

Set set(const Formula& formula, bool small) {
  switch (formula.kind) {
    case Kind::number:
      return {formula.text, 0.5 * static_cast<double>(formula.text.size())};
    case Kind::name: {
      const std::string upright = upright_function(formula.text);
      if (!upright.empty()) return {"\\operatorname{" + upright + "}", 1.5};
      return name(formula.text);
    }
    case Kind::sum:
      return sum(formula, small);
    case Kind::negative: {
      Set result{"-", 0.8};
      result += is_compound(formula.parts[0]) ? factor(formula.parts[0], small)
                                              : set(formula.parts[0], small);
      return result;
    }
    case Kind::product:
      return product(formula, small);
    case Kind::adjacent: {
      Set result;
      for (const Formula& part : formula.parts) {
        if (!result.code.empty()) result += thin_space;
        result += factor(part, small);
      }
      return result;
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
    case Kind::absolute:
      return fenced(set(formula.parts[0], small), "|", "|");
    case Kind::relation:
      return relation(formula, small);
    case Kind::verbatim:
      break;
  }
  return {"\\text{" + latex_escaped(formula.text) + "}",
          0.5 * static_cast<double>(formula.text.size())};
}

/// "= -" as two signs; a line that begins with one needs {} for its spacing.
std::string signs(const std::string& sign) {
  if (sign.ends_with(" -")) return latex_sign(sign.substr(0, sign.size() - 2)) + " -";
  return sign.empty() ? "" : latex_sign(sign);
}

Set set(const Piece& piece) {
  Set result;
  if (!piece.sign.empty()) result = {signs(piece.sign), relation_width};
  for (int i = 0; i < piece.opens; ++i) result += {"\\bigl(", 0.5};
  result += piece.factor || piece.sign.ends_with('-') ? factor(piece.formula, false)
                                                      : set(piece.formula, false);
  for (int i = 0; i < piece.closes; ++i) result += {"\\bigr)", 0.5};
  return result;
}

}  // namespace

std::string latex(const Formula& formula) { return set(formula, false).code; }

double latex_width(const Formula& formula) { return set(formula, false).width; }

std::string latex_display(const Formula& equation, double room) {
  const Set whole = set(equation, false);
  if (whole.width <= room) return whole.code;
  std::string code = "\\begin{aligned}\n& ";
  double used = 0;
  for (const Piece& piece : pieces(equation, latex_width, room - 6)) {
    const Set next = set(piece);
    const bool relates = piece.sign.find_first_of("=<>!") != std::string::npos;
    if (used > 0 && (used + next.width > room || (relates && used > room / 3))) {
      code += " \\\\\n& \\quad {}";
      used = 1;
    }
    code += " " + next.code;
    used += next.width;
  }
  return code + "\n\\end{aligned}";
}

std::string latex_escaped(std::string_view text) {
  static const std::map<char, std::string> escapes{{'\\', "\\textbackslash{}"},
                                                   {'{', "\\{"},
                                                   {'}', "\\}"},
                                                   {'$', "\\$"},
                                                   {'&', "\\&"},
                                                   {'#', "\\#"},
                                                   {'%', "\\%"},
                                                   {'_', "\\_"},
                                                   {'^', "\\textasciicircum{}"},
                                                   {'~', "\\textasciitilde{}"},
                                                   {'<', "\\textless{}"},
                                                   {'>', "\\textgreater{}"},
                                                   {'|', "\\textbar{}"},
                                                   {'"', "\\textquotedbl{}"},
                                                   {'\'', "\\textquotesingle{}"}};
  std::string result;
  for (const char character : text) {
    const auto escape = escapes.find(character);
    result += escape == escapes.end() ? std::string(1, character) : escape->second;
  }
  return result;
}

}  // namespace magicmass::render
